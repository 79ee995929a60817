#pragma once

#include "material/plasticity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace platen::material {

/// Linear Drucker-Prager (Wang et al., eqs 1-7), p tension positive:
///
///   t + p tan(beta) = d,   d = sigma_c (1 - tan(beta)/3)   (their eq. 6; = sigma_Y of eq. 14)
///   t = q/2 (1 + 1/K - (1 - 1/K) (r/q)^3),   r^3 = 27/2 det(s)
///
/// up to the apex p = d/tan(beta). K is the strength in triaxial extension over that in compression; with
/// K = 1 the section is a circle and t = q. Flow from t + p tan(psi): with K = 1, d(eps_v^p) =
/// tan(psi) d(eps_q^p) on the line, and any direction between that and pure dilation at the apex. Perfectly
/// plastic; phi = -eps_v^p is kept for the volume of the unloaded material alone.
struct DruckerPrager {
  double E;        ///< Young's modulus (Pa), > 0
  double nu;       ///< Poisson's ratio, in [0, 0.5)
  double beta_deg; ///< friction angle in the (p, q) plane (degrees), in (0, atan 3)
  double sigma_c;  ///< uniaxial compressive strength (Pa), > 0
  double psi_deg;  ///< dilation angle in the (p, q) plane (degrees), in [0, beta]; beta: associated
  double flow_stress_ratio = 1; ///< K, in [7/9, 1]: below 7/9 the section is not convex

  static constexpr std::string_view name = "drucker-prager";
  static const CardSection<DruckerPrager>& card();

  static constexpr PhiRate phi_rate{-1, 0};
  static constexpr bool fixed_moduli = true, perfectly_plastic = true;

  /// beta of a friction angle phi measured in triaxial compression (degrees): tan(beta) = 6 sin(phi)/(3 -
  /// sin(phi)) (WG eq. 7).
  static double beta_of_friction(double phi_deg) {
    const double sin_phi = std::sin(phi_deg * degree);
    return std::atan(6 * sin_phi / (3 - sin_phi)) / degree;
  }
  /// phi of beta (degrees): the number of ten decimals that has this beta, where there is one.
  double friction_deg() const {
    const double tan_beta = std::tan(beta_deg * degree);
    const double phi = std::asin(3 * tan_beta / (6 + tan_beta)) / degree,
                 rounded = std::round(phi * 1e10) / 1e10;
    return std::abs(beta_of_friction(rounded) - beta_deg) < 1e-14 * beta_deg ? rounded : phi;
  }
  /// sigma_c = 2 C cos(phi)/(1 - sin(phi)) (WG eq. 15).
  static double strength_of_cohesion(double cohesion, double phi_deg) {
    return 2 * cohesion * std::cos(phi_deg * degree) / (1 - std::sin(phi_deg * degree));
  }

  /// s in Pa: on the line s = p_apex - p > 0, to a pressure p_end that stands for no end, see
  /// elastic_pressure_max; at the apex, s in [-d, 0], the normal alone turns.
  struct Surface {
    double d, tan_beta, tan_psi, p_end;

    double p_apex() const { return d / tan_beta; }
    double s_min() const { return -d; }
    double s_max() const { return p_apex() + p_end; }

    SurfacePoint at(double s) const {
      if (s < 0) {
        const double angle_s = angle_of_line() / d, angle = angle_of_line() + angle_s * s;
        const double c = std::cos(angle), n = std::sin(angle);
        return {p_apex(), 0, 0, 0, 0, 0, c, n, -n * angle_s, c * angle_s, 0, 0};
      }
      const double length = std::hypot(tan_psi, 1);
      return {p_apex() - s, s * tan_beta, -1, tan_beta, 0, 0, tan_psi / length, 1 / length, 0, 0, 0, 0};
    }
    bool contains(double p, double q) const { return q + p * tan_beta <= d; }
    /// The return of small strains: along (K tan_psi, 3G) to the line, radially to the apex.
    double first_guess(double p, double q, const Moduli& m) const {
      const double K_over_3G = m.K / (3 * m.G);
      const double flow = (q + p * tan_beta - d) / (1 + K_over_3G * tan_psi * tan_beta);
      const double p_line = p - K_over_3G * tan_psi * flow;
      if (p_line <= p_apex()) return p_apex() - p_line;
      return d * (std::atan2(q * K_over_3G, p - p_apex()) / angle_of_line() - 1);
    }
    Zone zone(double s) const { return s < 0 ? Zone::tension : Zone::shear; }
    std::array<double, 2> drawn(double p_low, double) const { return {0, std::max(p_apex() - p_low, 0.0)}; }

   private:
    double angle_of_line() const { return std::atan2(1, tan_psi); } ///< of the flow, from the axis p
  };

  Moduli moduli(double) const { return isotropic_moduli(E, nu); }
  Surface surface(double) const {
    const double tan_beta = std::tan(beta_deg * degree);
    return {sigma_c * (1 - tan_beta / 3), tan_beta, std::tan(psi_deg * degree), elastic_pressure_max(E, nu)};
  }

  double reference_stress() const { return sigma_c; }

  bool circular() const { return flow_stress_ratio == 1; }

  /// t + p tan(beta) - d (Pa) of principal stresses in any order.
  double excess(const std::array<double, 3>& sigma) const;
  /// Backward Euler where the section is no circle, see the .cpp.
  [[nodiscard]] PrincipalResponse respond(const std::array<double, 3>& eps_trial) const;
  /// Triaxial compression and extension, from the apex to p_low.
  std::vector<YieldCurve> meridians(double p_low) const;

 private:
  static constexpr double degree = std::numbers::pi / 180;
};

} // namespace platen::material
