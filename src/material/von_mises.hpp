#pragma once

#include "material/plasticity.hpp"

namespace platen::material {

/// von Mises, perfectly plastic: q = sigma_y in Cauchy stress. phi is the equivalent plastic strain (ES eq.
/// 2).
struct VonMises {
  double E;       ///< Young's modulus (Pa), > 0
  double nu;      ///< Poisson's ratio, in [0, 0.5)
  double sigma_y; ///< uniaxial yield stress (Pa), > 0

  static constexpr PhiRate phi_rate{0, 1};

  /// s = -p: the surface is a line without ends.
  struct Surface {
    double sigma_y;
    SurfacePoint at(double s) const { return {-s, sigma_y, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0}; }
    double s_min() const { return -1e6 * sigma_y; }
    double s_max() const { return 1e6 * sigma_y; }
    bool contains(double, double q) const { return q <= sigma_y; }
    double first_guess(double p, double, const Moduli&) const { return -p; }
    Zone zone(double) const { return Zone::shear; }
  };

  Moduli moduli(double) const { return isotropic_moduli(E, nu); }
  Surface surface(double) const { return {sigma_y}; }
};

} // namespace platen::material
