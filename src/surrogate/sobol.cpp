#include "surrogate/sobol.hpp"

#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "study/random.hpp"
#include "surrogate/assess.hpp"
#include "surrogate/said.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace platen::surrogate {
namespace {

/// The material with other numbers, those of its description in their order.
material::Model with_numbers(const material::Model& model, const std::vector<double>& n) {
  if (const auto* vmdc = std::get_if<material::Vmdc>(&model)) {
    material::Vmdc m = *vmdc;
    m.rho_r0 = n[0];
    m.E = n[1] * m.sigma_y;
    m.nu = n[2];
    m.Gamma = n[3] * m.sigma_y;
    m.Lambda = n[4] * m.sigma_y;
    m.epsilon = n[5], m.eta = n[6], m.xi = n[7], m.zeta = n[8], m.omega = n[9], m.xi_1 = n[10],
    m.xi_2 = n[11];
    return m;
  }
  if (const auto* metal = std::get_if<material::VonMises>(&model);
      metal && std::holds_alternative<material::PerfectlyPlastic>(metal->hardening)) {
    material::VonMises m = *metal;
    m.E = n[0] * m.sigma_y;
    m.nu = n[1];
    return m;
  }
  if (std::holds_alternative<material::Elastic>(model)) {
    material::Elastic m = std::get<material::Elastic>(model);
    m.nu = n[0];
    return m;
  }
  throw core::InvalidInput("sensitivities are told of elastic, perfectly plastic and vmdc materials");
}

const std::vector<double> overlaps = {0.1, 0.3, 0.5};

std::vector<std::string> output_names() {
  std::vector<std::string> names;
  for (const double x : overlaps) names.push_back(fmt::format("F at {}", x));
  names.push_back(fmt::format("work put in to {}", overlaps.back()));
  names.push_back(fmt::format("work given back from {}", overlaps.back()));
  return names;
}

std::vector<double> outputs_of(const Surrogate& s, const material::Model& model) {
  const auto d = describe(model);
  const auto at = input_of(s, d.coordinates);
  const Said said = said_at(s, at, nullptr, Want::force_and_work);
  const auto F = exponentials(said.F, 0, said.F.size());
  std::vector<double> outputs;
  const auto knot = [&](double x) {
    return static_cast<std::size_t>(std::lower_bound(s.knots.begin(), s.knots.end(), x - 1e-9) -
                                    s.knots.begin());
  };
  for (const double x : overlaps) outputs.push_back(F[knot(x)]);
  double put_in = F[0] * s.knots[0] / 2;
  for (std::size_t j = 1; j <= knot(overlaps.back()); ++j)
    put_in += (F[j] + F[j - 1]) / 2 * (s.knots[j] - s.knots[j - 1]);
  outputs.push_back(put_in);
  const double F_max = F[knot(overlaps.back())];
  const double hertz = std::pow(0.75 * std::numbers::pi * F_max / d.E_flat, 2.0 / 3); // ES (12)
  outputs.push_back(F_max * hertz * std::exp(said.work.back()));
  return outputs;
}

std::vector<double> numbers_of(const Description& d) {
  std::vector<double> numbers;
  for (const auto& n : d.numbers) numbers.push_back(n.value);
  return numbers;
}

/// Numbers that the pool varies.
std::vector<std::size_t> varying(const Surrogate& s) {
  std::vector<std::size_t> which;
  for (std::size_t k = 0; k < s.ranges.size(); ++k)
    if (s.ranges[k].high - s.ranges[k].low > 1e-9) which.push_back(k);
  return which;
}

/// Empty, or why not.
std::string refusal(const Surrogate& s, const Description& d) {
  for (std::size_t k = 0; k < s.ranges.size(); ++k) {
    const auto& [key, low, high] = s.ranges[k];
    const double x = d.numbers[k].value, slack = 1e-6 * std::max(std::abs(low), std::abs(high)) + 1e-12;
    if (x < low - slack || x > high + slack)
      return fmt::format("{} = {:.4g} is not in {:.4g} to {:.4g}", key, x, low, high);
  }
  return {};
}

} // namespace

Sensitivity sobol(const Surrogate& s, const material::Model& model, double within, int samples, int seed) {
  const auto d = describe(model);
  if (const auto why = refusal(s, d); !why.empty())
    throw core::InvalidInput(fmt::format("pool {}: {}", s.pool, why));
  const auto ln_F = said_at(s, input_of(s, d.coordinates), nullptr, Want::force_and_work).F;
  if (grows(locked_growth, s.knots, exponentials(ln_F, 0, ln_F.size())))
    throw core::InvalidInput(
        fmt::format("pool {}: it locks, and pools know nothing of such materials", s.pool));
  const auto base = numbers_of(d);
  const auto which = varying(s);
  Sensitivity result{s.pool, output_names(), {}, {}, {}};
  for (std::size_t k = 0; k < s.ranges.size(); ++k)
    if (std::find(which.begin(), which.end(), k) == which.end()) result.held.push_back(s.ranges[k].key);
  for (const std::size_t k : which) {
    const auto [one, other] = std::minmax({base[k] * (1 - within), base[k] * (1 + within)});
    const std::vector<double> none(result.outputs.size());
    result.numbers.push_back(
        {s.ranges[k].key, std::max(one, s.ranges[k].low), std::min(other, s.ranges[k].high), none, none});
  }
  const auto at = [&](const std::vector<double>& place) {
    auto numbers = base;
    for (std::size_t i = 0; i < which.size(); ++i) numbers[which[i]] = place[i];
    return outputs_of(s, with_numbers(model, numbers));
  };
  result.deviation = sobol_indices(at, result.numbers, samples, seed);
  return result;
}

std::vector<double> sobol_indices(const std::function<std::vector<double>(const std::vector<double>&)>& f,
                                  std::vector<SobolIndices>& numbers, int samples, int seed) {
  study::Random random(static_cast<std::uint64_t>(seed));
  std::vector<std::vector<double>> of_A, of_B;
  std::vector<std::vector<std::vector<double>>> of_A_i; // by sample, by number
  for (int sample = 0; sample < samples; ++sample) {
    core::stop_if_asked();
    const auto draw = [&] {
      std::vector<double> place;
      for (const auto& n : numbers) place.push_back(n.low + (n.high - n.low) * random.uniform());
      return place;
    };
    const auto A = draw(), B = draw();
    of_A.push_back(f(A));
    of_B.push_back(f(B));
    auto& one = of_A_i.emplace_back();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      auto A_i = A;
      A_i[i] = B[i];
      one.push_back(f(A_i));
    }
  }
  std::vector<double> deviation;
  const std::size_t outputs = of_A.front().size();
  for (auto& n : numbers) n.alone.resize(outputs), n.total.resize(outputs);
  for (std::size_t o = 0; o < outputs; ++o) {
    const double count = 2.0 * samples;
    double mean = 0, variance = 0;
    for (const auto* all : {&of_A, &of_B})
      for (const auto& one : *all) mean += one[o] / count;
    for (const auto* all : {&of_A, &of_B})
      for (const auto& one : *all) variance += std::pow(one[o] - mean, 2) / (count - 1);
    deviation.push_back(std::sqrt(variance) / std::abs(mean));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      double alone = 0, total = 0;
      for (std::size_t j = 0; j < of_A.size(); ++j) {
        const double change = of_A_i[j][i][o] - of_A[j][o];
        alone += (of_B[j][o] - mean) * change / samples;
        total += change * change / (2.0 * samples);
      }
      numbers[i].alone[o] = variance > 0 ? alone / variance : 0;
      numbers[i].total[o] = variance > 0 ? total / variance : 0;
    }
  }
  return deviation;
}

Sensitivity sobol_of_catalogue(const material::Material& material, double within) {
  const auto d = describe(material.model);
  with_numbers(material.model, numbers_of(d));
  std::optional<Surrogate> best;
  std::string why;
  for (auto& s : catalogue_surrogates(d.model)) {
    if (auto refused = refusal(s, d); !refused.empty()) {
      why += fmt::format("{}pool {}: {}", why.empty() ? "" : "; ", s.pool, refused);
      continue;
    }
    if (!best || varying(s).size() > varying(*best).size()) best = std::move(s);
  }
  if (!best)
    throw core::InvalidInput(fmt::format("{} is in the ranges of no pool ({})", material.name,
                                         why.empty() ? "there is none of its model" : why));
  return sobol(*best, material.model, within);
}

} // namespace platen::surrogate
