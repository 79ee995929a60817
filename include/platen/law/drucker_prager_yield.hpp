#pragma once
// Where the Hertz field first reaches the linear Drucker-Prager surface: Wang et al., "A Simple Model for
// Elastic-Plastic Contact of Granular Geomaterials" (2018), (4)-(13). Stress: tension positive, yield is
// sqrt(J2) + alpha I1 = k.

#include "platen/law/error.hpp"

#include <cmath>
#include <numbers>

namespace platen::law {

struct DruckerPragerYield {
  double alpha; ///< (5) [-]
  double k;     ///< (6) [Pa]
  double u;     ///< depth of first yield on the axis over the contact radius [-]
  double p0;    ///< peak pressure at first yield on the axis [Pa]; the paper's, and the law's normaliser
  double
      p0_edge; ///< peak pressure at which the edge of the contact yields: I1 = 0, sqrt(J2) = (1 - 2 nu) p0/3
};

/// (10) with the factor (1 + nu) that the print lost and (9) has: k/p0 at depth u = z/a on the axis.
inline double drucker_prager_amplitude(double nu, double u, double alpha) {
  const double shed = (1 + nu) * (u > 0 ? 1 - u * std::atan(1 / u) : 1); // (1 + nu)(1 - u atan(1/u))
  return (1.5 / (1 + u * u) - shed) / std::numbers::sqrt3 - 2 * alpha * shed;
}

inline DruckerPragerYield drucker_prager_yield(double nu, double phi_deg, double sigma_c) {
  require("wang", "nu", nu, poisson);
  require("wang", "phi_deg", phi_deg, {0, 60, false, true});
  require("wang", "sigma_c_Pa", sigma_c, positive);
  const double sin_phi = std::sin(phi_deg * std::numbers::pi / 180);
  DruckerPragerYield y{};
  y.alpha = 2 * sin_phi / (std::numbers::sqrt3 * (3 - sin_phi));
  y.k = (1 - std::numbers::sqrt3 * y.alpha) * sigma_c / std::numbers::sqrt3;
  // (11) by golden section: on the axis the amplitude rises to one maximum and decays like 1/u^2
  const double golden = (std::sqrt(5.0) - 1) / 2;
  double low = 0, high = 20;
  for (int i = 0; i < 100; ++i) {
    const double step = golden * (high - low);
    const double left = high - step, right = low + step;
    if (drucker_prager_amplitude(nu, left, y.alpha) < drucker_prager_amplitude(nu, right, y.alpha))
      low = left;
    else high = right;
  }
  y.u = (low + high) / 2;
  const double amplitude = drucker_prager_amplitude(nu, y.u, y.alpha);
  require("wang", "k/p0 at first yield (phi_deg too large: the axis never yields)", amplitude, positive);
  y.p0 = y.k / amplitude;
  y.p0_edge = 3 * y.k / (1 - 2 * nu);
  return y;
}

} // namespace platen::law
