#include "fit/first_yield.hpp"

#include "platen/law/drucker_prager_yield.hpp"

#include <numbers>

namespace platen::fit {

FirstYield first_yield(double E, double nu, double phi_deg, double sigma_c, double R) {
  const double p0 = law::drucker_prager_yield(nu, phi_deg, sigma_c).p0;
  const double E_star = E / (1 - nu * nu), a = std::numbers::pi * p0 / (2 * E_star) * R;
  return {2 * std::numbers::pi / 3 * p0 * a * a, a * a / R, a};
}

} // namespace platen::fit
