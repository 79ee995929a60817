#include "calibrate/curves.hpp"

#include "fit/refine_unloading.hpp"

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
  fit::refine_unloading(m);
  return m;
}

} // namespace platen::calibrate
