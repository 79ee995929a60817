#include "material/reserve.hpp"

#include "material/update.hpp"

#include <cmath>
#include <limits>

namespace platen::material {
namespace {

/// Bisection of a factor between inside and outside.
template <class Inside> double largest_factor(const Inside& inside) {
  if (!inside(1)) return 0;
  double low = 1, high = 1e6;
  if (inside(high)) return std::numeric_limits<double>::infinity();
  while (high > low * (1 + 1e-9)) {
    const double middle = std::sqrt(low * high);
    (inside(middle) ? low : high) = middle;
  }
  return low;
}

} // namespace

double stress_reserve(const Model& model, const std::array<double, 3>& sigma, double phi) {
  const double p = (sigma[0] + sigma[1] + sigma[2]) / 3, q = 1.5 * invariants(sigma).eps_q;
  return std::visit(
      [&]<class M>(const M& m) {
        if constexpr (InvariantModel<M>)
          if (in_invariants(m)) {
            const auto surface = m.surface(phi);
            return largest_factor([&](double f) { return surface.contains(f * p, f * q); });
          }
        if constexpr (PrincipalModel<M>)
          return largest_factor([&](double f) {
            return m.excess({f * sigma[0], f * sigma[1], f * sigma[2]}) <= 0;
          });
        else return std::numeric_limits<double>::infinity();
      },
      model);
}

} // namespace platen::material
