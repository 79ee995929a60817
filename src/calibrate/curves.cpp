#include "calibrate/curves.hpp"

#include <algorithm>
#include <cmath>

namespace platen::calibrate {
namespace {

std::vector<double> exponentials(std::vector<double> values) {
  for (double& v : values) v = std::exp(v);
  return values;
}

/// Each value at least the one before and `least` of it more.
std::vector<double> growing(std::vector<double> values, double least) {
  for (std::size_t i = 1; i < values.size(); ++i)
    values[i] = std::max(values[i], values[i - 1] * (1 + least));
  return values;
}

void refine_unloading(law::PressedMaterial& m) {
  const std::size_t n = m.unload_delta_bar.size();
  if (n < 4) return;
  const auto x = m.unload_delta_bar;
  const auto cubic = [&](const std::vector<double>& y, double at) {
    const auto above = static_cast<std::size_t>(std::ranges::upper_bound(x, at) - x.begin());
    const std::size_t first = std::min(above < 2 ? 0 : above - 2, n - 4);
    double sum = 0;
    for (std::size_t i = first; i < first + 4; ++i) {
      double weight = 1;
      for (std::size_t j = first; j < first + 4; ++j)
        if (j != i) weight *= (at - x[j]) / (x[i] - x[j]);
      sum += weight * y[i];
    }
    return sum;
  };
  std::vector<double> at, alpha, ln_beta, ln_beta_at;
  for (const double beta : m.beta) ln_beta.push_back(std::log(beta));
  constexpr int parts = 20;
  for (int i = 0; i <= parts; ++i) { // from half of the first on
    at.push_back(x.front() / 2 + (x.back() - x.front() / 2) * i / parts);
    alpha.push_back(std::clamp(cubic(m.alpha, at.back()), 1.0, 10.0));
    ln_beta_at.push_back(cubic(ln_beta, at.back()));
  }
  m.unload_delta_bar = at, m.alpha = alpha;
  m.beta = exponentials(ln_beta_at);
}

} // namespace

law::PressedMaterial curve_of(const LogCurve& c, const material::Material& material, double sigma_ref) {
  law::PressedMaterial m{material::initial_E(material.model),
                         material::initial_nu(material.model),
                         sigma_ref,
                         c.delta_bar,
                         growing(exponentials(c.F), 2e-5),
                         growing(exponentials(c.a), 0),
                         c.unload_delta_bar,
                         exponentials(c.alpha),
                         exponentials(c.beta)};
  for (double& alpha : m.alpha) alpha = std::clamp(alpha, 1.0, 10.0); // what the law takes
  refine_unloading(m);
  return m;
}

} // namespace platen::calibrate
