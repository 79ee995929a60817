#pragma once

#include "material/hardening.hpp"
#include "material/plasticity.hpp"

#include <array>

namespace platen::material {

/// von Mises: q = sigma(phi) in Cauchy stress, associated flow. phi is the equivalent plastic strain (ES eq.
/// 2).
struct VonMises {
  double E;                 ///< Young's modulus (Pa), > 0
  double nu;                ///< Poisson's ratio, in [0, 0.5)
  double sigma_y;           ///< uniaxial yield stress at phi = 0 (Pa), > 0
  Hardening hardening = {}; ///< sigma(phi)

  static constexpr std::string_view name = "von-mises";
  static const CardSection<VonMises>& card();

  static constexpr PhiRate phi_rate{0, 1};
  static constexpr bool fixed_moduli = true;

  /// s = -p: the surface is a line without ends; p_end stands for them, see elastic_pressure_max.
  struct Surface {
    double sigma_y, slope, p_end;
    SurfacePoint at(double s) const { return {-s, sigma_y, -1, 0, 0, slope, 0, 1, 0, 0, 0, 0}; }
    double s_min() const { return -p_end; }
    double s_max() const { return p_end; }
    bool contains(double, double q) const { return q <= sigma_y; }
    double first_guess(double p, double, const Moduli&) const { return -p; }
    Zone zone(double) const { return Zone::shear; }
    std::array<double, 2> drawn(double p_low, double p_high) const { return {-p_high, -p_low}; }
  };

  Moduli moduli(double) const { return isotropic_moduli(E, nu); }
  Surface surface(double phi) const {
    const YieldStress sigma = yield_stress(hardening, E, sigma_y, phi);
    return {sigma.value, sigma.slope, elastic_pressure_max(E, nu)};
  }

  Bounds bounds(double phi) const {
    const auto* table = std::get_if<HardeningTable>(&hardening);
    Bounds b;
    b.table = table && phi > table->last_strain();
    return b;
  }

  /// The strength coefficient where the law has no proper yield stress (Shahin, section 3), else sigma_y.
  double reference_stress() const {
    const auto* hollomon = std::get_if<Hollomon>(&hardening);
    return hollomon ? hollomon->kappa : sigma_y;
  }
};

} // namespace platen::material
