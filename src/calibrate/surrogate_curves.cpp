#include "calibrate/curves.hpp"
#include "core/error.hpp"
#include "surrogate/said.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <tuple>

namespace platen::calibrate {
namespace {

using namespace surrogate;

/// Refused: a number beyond those of the pool, by more than rounding; one that all of them share is judged at
/// the end.
void check_inside(const Surrogate& s, const Description& d) {
  for (std::size_t k = 0; k < s.ranges.size(); ++k) {
    const auto& [key, low, high] = s.ranges[k];
    const double value = d.numbers[k].value, slack = 1e-6 * std::max(std::abs(low), std::abs(high)) + 1e-12;
    if (high - low > slack && !(value >= low - slack && value <= high + slack))
      throw core::InvalidInput(fmt::format("{} = {:.6g} is not in {:.6g} to {:.6g}", key, value, low, high));
  }
}

law::PressedMaterial curve(const Surrogate& s, const Said& l, const material::Material& material) {
  auto [alpha, beta] = alpha_beta(l.work, l.exponent);
  return curve_of(
      {s.knots, l.F, l.a, s.unload_delta_bar, logarithms(std::move(alpha)), logarithms(std::move(beta))},
      material, describe(material.model).sigma_ref);
}

/// Standard deviation of a score; `wider`: of the band over what the processes would have.
double deviation(const Process& process, const Columns& inputs, const std::vector<double>& at, double wider) {
  return wider * std::sqrt(variances({&process, 1}, inputs, at)[0] + process.nugget * process.variance);
}

} // namespace

Curves surrogate_curves(const material::Material& typical) {
  const auto s = std::make_shared<const Surrogate>(ask_catalogue(describe(typical.model)).surrogate);
  const auto described = [s](const material::Material& m) {
    const auto d = describe(m.model);
    check_inside(*s, d);
    return d;
  };
  Curves curves;
  curves.of = [s, described](const material::Material& m) {
    return curve(*s, said_at(*s, input_of(*s, described(m).coordinates)), m);
  };
  curves.astray = [s, described](const material::Material& m) {
    const auto d = described(m);
    const auto at = input_of(*s, d.coordinates);
    const auto best = said_at(*s, at);
    constexpr double nominal = 1.645; // half the 90 % band of a normal distribution
    const double wider = s->band / nominal;
    std::vector<law::PressedMaterial> ways;
    auto rest = said_of(*s, d, nullptr).F_variance; // in the end of what no component holds
    for (double& variance : rest) variance *= wider * wider;
    for (const auto& layer : s->layers) {
      const double scatter = &layer == &s->layers.front() ? 1 : best.scatter;
      for (std::size_t c = 0; c < layer.force.basis.size(); ++c) {
        const double by = scatter * deviation(layer.force.processes[c], layer.columns, at, wider);
        auto other = best;
        for (std::size_t j = 0; j < other.F.size(); ++j) {
          other.F[j] += by * layer.force.basis[c][j];
          rest[j] -= std::pow(by * layer.force.basis[c][j], 2);
        }
        ways.push_back(curve(*s, other, m));
      }
      for (const auto& [components, values, factor] :
           {std::tuple{&Layer::work, &Said::work, scatter}, {&Layer::exponent, &Said::exponent, 1.0}}) {
        const Components& of = layer.*components;
        for (std::size_t c = 0; c < of.basis.size(); ++c) {
          const double by = factor * deviation(of.processes[c], layer.columns, at, 1);
          auto other = best;
          for (std::size_t j = 0; j < (other.*values).size(); ++j) (other.*values)[j] += by * of.basis[c][j];
          ways.push_back(curve(*s, other, m));
        }
      }
    }
    auto other = best;
    for (std::size_t j = 0; j < other.F.size(); ++j) other.F[j] += std::sqrt(std::max(0.0, rest[j]));
    ways.push_back(curve(*s, other, m));
    return ways;
  };
  return curves;
}

surrogate::Answer surrogate_answer(const material::Material& typical, const material::Material& material) {
  const auto s = ask_catalogue(describe(typical.model)).surrogate;
  return std::move(*ask(s, describe(material.model), {}));
}

} // namespace platen::calibrate
