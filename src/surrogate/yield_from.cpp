#include "surrogate/yield_from.hpp"

#include "core/error.hpp"
#include "material/card.hpp"
#include "surrogate/assess.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace platen::surrogate {
namespace {

constexpr double tabor = 2.8;                       // H/sigma_y
constexpr double fully_plastic = 30, slope = 0.358; // tan(19.7 degrees)

Description metal(double E, double nu, double sigma_y) {
  return describe(material::VonMises{E, nu, sigma_y, material::PerfectlyPlastic{}});
}

void refuse_unless_elastic(double E, double nu) {
  if (!(E > 0) || !std::isnormal(E) || !(nu >= 0 && nu < 0.5))
    throw core::InvalidInput(
        fmt::format("E_Pa = {:.4g}, nu = {:.4g}: E_Pa must be a number above 0, nu in [0, 0.5)", E, nu));
}

} // namespace

double yield_from_hardness(double E, double nu, double H) {
  refuse_unless_elastic(E, nu);
  if (!(H > 0) || !std::isnormal(H / tabor))
    throw core::InvalidInput(fmt::format("hardness_Pa = {:.4g} is no number above 0", H));
  const double sigma_y = H / tabor, reached = E / (1 - nu * nu) * slope / sigma_y;
  if (reached < fully_plastic)
    throw core::InvalidInput(
        fmt::format("hardness_Pa = {:.4g} with E_Pa = {:.4g}: such an indentation is partly elastic (E "
                    "tan(19.7 deg)/((1 - nu^2) sigma_y) = "
                    "{:.3g}, below {}), and H = {} sigma_y does not hold; give --sigma_y_Pa",
                    H, E, reached, fully_plastic, tabor));
  return sigma_y;
}

double yield_from_heckel(double E, double nu, double P_y) {
  constexpr double stiff = 30;
  refuse_unless_elastic(E, nu);
  if (!(P_y > 0) || !std::isnormal(P_y / 3))
    throw core::InvalidInput(fmt::format("heckel_Pa = {:.4g} is no number above 0", P_y));
  const double sigma_y = P_y / 3;
  if (E / sigma_y < stiff)
    throw core::InvalidInput(
        fmt::format("heckel_Pa = {:.4g} with E_Pa = {:.4g}: such grains spring back (E/sigma_y = {:.3g}, "
                    "below {}), and P_y = 3 sigma_y does not hold; give --sigma_y_Pa",
                    P_y, E, E / sigma_y, stiff));
  return sigma_y;
}

double yield_from_crushing(double E, double nu, double F, double delta, double R) {
  refuse_unless_elastic(E, nu);
  if (!(R > 0) || !(F > 0) || !(delta / R >= 0.01 && delta / R <= 0.5))
    throw core::InvalidInput(fmt::format(
        "a force of {:.4g} N at {:.4g} m of a sphere of R = {:.4g} m: the overlap, of one plate, must "
        "be 0.01 to 0.5 of R, all above 0",
        F, delta, R));
  const auto pools = catalogue_surrogates("von-mises");
  if (pools.empty()) throw core::InvalidInput("the catalogue has no surrogate of perfectly plastic metals");
  const Surrogate& s = pools.front();
  const auto force = [&](double sigma_y) {
    const auto p = predict(s, metal(E, nu, sigma_y));
    std::size_t above = 0;
    while (above + 1 < s.knots.size() && s.knots[above] < delta / R) ++above;
    const std::size_t below = above > 0 ? above - 1 : 0;
    const double part =
        above > below ? std::log(delta / R / s.knots[below]) / std::log(s.knots[above] / s.knots[below]) : 0;
    return std::numbers::pi * R * R * sigma_y * p.F_bar[below] *
           std::pow(p.F_bar[above] / p.F_bar[below], part);
  };
  double weak = E / s.ranges[0].high, strong = E / s.ranges[0].low;
  const double least = force(weak), most = force(strong);
  if (F < least || F > most)
    throw core::InvalidInput(fmt::format("a force of {:.4g} N at {:.4g} m of a sphere of R = {:.4g} m with "
                                         "E_Pa = {:.4g}: perfectly plastic materials of E/sigma_y from "
                                         "{:.3g} to {:.3g} carry {:.3g} to {:.3g} N there{}",
                                         F, delta, R, E, s.ranges[0].low, s.ranges[0].high, least, most,
                                         F > most ? "; more than that is more than E allows" : ""));
  for (int i = 0; i < 60; ++i) {
    const double middle = std::sqrt(weak * strong);
    (force(middle) < F ? weak : strong) = middle;
  }
  return std::sqrt(weak * strong);
}

material::Vmdc granule_from(const Indices& known) {
  if (!(known.strain > 0) || !(known.bonding > 0) || !std::isfinite(known.strain))
    throw core::InvalidInput(fmt::format(
        "strain_index = {:.4g}, bonding_index = {:.4g}: both must be above 0", known.strain, known.bonding));
  if (!(known.hardness_Pa > 0) || !std::isnormal(known.hardness_Pa))
    throw core::InvalidInput(fmt::format("hardness_Pa = {:.4g} is no number above 0", known.hardness_Pa));
  if (known.strain > slope * tabor / fully_plastic)
    throw core::InvalidInput(fmt::format("strain_index = {:.4g}: above {:.2g} such an indentation is partly "
                                         "elastic, and H = {} Gamma does not hold",
                                         known.strain, slope * tabor / fully_plastic, tabor));
  if (!(known.relative_density >= 0.5 && known.relative_density <= 1))
    throw core::InvalidInput(
        fmt::format("relative_density = {:.4g} of the compacts is not in 0.5 to 1", known.relative_density));
  auto granule = std::get<material::Vmdc>(material::read_card("base-case").material.model);
  const double denser = known.relative_density - granule.rho_r0;
  const double nu = granule.nu + granule.xi_1 * denser;
  const double E = known.hardness_Pa * (1 - nu * nu) / known.strain,
               sigma_T = known.bonding * known.hardness_Pa;
  const double Gamma = known.hardness_Pa / tabor;
  if (sigma_T >= Gamma)
    throw core::InvalidInput(fmt::format(
        "bonding_index = {:.4g}: a tensile strength of {:.4g} Pa is no less than the shear strength H/2.8 = "
        "{:.4g} Pa; indices are fractions, mostly below 0.06",
        known.bonding, sigma_T, Gamma));
  // (sigma_T/3 Lambda)^2 + (sigma_T/Gamma)^2 = 1
  const double Lambda = sigma_T / 3 / std::sqrt(1 - std::pow(sigma_T / Gamma, 2));
  const double of_base = granule.sigma_y / granule.Gamma;
  granule.Gamma = Gamma * std::exp(-granule.zeta * denser);
  granule.sigma_y = of_base * granule.Gamma;
  granule.E = E * std::exp(-granule.xi * denser);
  granule.Lambda = Lambda * std::exp(-granule.omega * denser);
  return granule;
}

} // namespace platen::surrogate
