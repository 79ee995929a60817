#pragma once

#include "material/plasticity.hpp"

#include <array>
#include <vector>

namespace platen::material {

/// Mohr-Coulomb with a tension cut-off (Wang et al., section 3.4), tension positive, sigma_1 >= sigma_2 >=
/// sigma_3:
///
///   sigma_1 (1 + sin phi) - sigma_3 (1 - sin phi) = 2 C cos(phi),   sigma_1 = T_0
///
/// Flow of the planes by the same with psi for phi, of the cut-off associated. Perfectly plastic. The state
/// phi = -eps_v^p is kept for the volume of the unloaded material alone.
struct MohrCoulomb {
  double E;        ///< Young's modulus (Pa), > 0
  double nu;       ///< Poisson's ratio, in [0, 0.5)
  double phi_deg;  ///< friction angle (degrees), in [0, 90)
  double cohesion; ///< C (Pa), > 0
  double psi_deg;  ///< dilation angle (degrees), in [0, phi]; phi: associated
  double cutoff;   ///< T_0 (Pa), > 0 and below the apex C/tan(phi)

  static constexpr std::string_view name = "mohr-coulomb";
  static const CardSection<MohrCoulomb>& card();

  static constexpr PhiRate phi_rate{-1, 0};

  Moduli moduli(double) const { return isotropic_moduli(E, nu); }

  /// Uniaxial compressive strength 2 C cos(phi)/(1 - sin(phi)) (WG eq. 15).
  double reference_stress() const;

  /// Largest of sigma_1 (1 + sin phi) - sigma_3 (1 - sin phi) - 2 C cos(phi) and sigma_1 - T_0 (Pa): inside
  /// where it is negative. Any order of the stresses.
  double excess(const std::array<double, 3>& sigma) const;

  /// Backward Euler, the corners included: the set of planes on which the stress ends is found by trying
  /// them.
  [[nodiscard]] PrincipalResponse respond(const std::array<double, 3>& eps_trial) const;

  /// Meridians of triaxial compression and extension, where two stresses are equal and the third is the most
  /// compressive or the most tensile: to be drawn from the cut-off to p_low.
  std::vector<YieldCurve> meridians(double p_low) const;
};

} // namespace platen::material
