#pragma once

#include "material/dual.hpp"
#include "material/porous.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace platen::material {

/// Drucker-Prager Cap through the same four points as the von Mises Double Cap (Edmans & Sinka, Tables 2 and
/// 3): hydrostatic yield at p = -sigma_y, peak Gamma at p = -pi_3 = epsilon Gamma - sigma_y, apex at p =
/// Lambda.
///
///   failure line  q = (Lambda - p) tan(beta),  tan(beta) = pi_6 = Gamma/(Lambda + pi_3)
///   transition    an arc about (-pi_3, (1 - A) Gamma), tangent to the line, level at p = -pi_3
///   cap           ((p + pi_3)/(epsilon Gamma))^2 + (B q/Gamma)^2 = 1 for p < -pi_3
///
/// Flow: associated on the cap. On line and arc
///
///   by default      as vmdc flows: pure shear while p < 0, then normal to
///                   (Lambda + pi_3) p^2 tan^2(beta)/Lambda + B^2 q^2, so pure dilation at the apex. The
///                   plastic power p dv + q dw is nowhere negative.
///   published_flow  the paper's potential, normal to (p + pi_3)^2 tan^2(beta) + B^2 q^2: it dilates
///                   against a pressure, and the plastic power is negative on much of the line where Lambda
///                   is small.
///
/// The paper gives no pi_8, the radius of the arc. Here pi_8 = A cos(beta), A = 0.02: the top is at most 2 %
/// below Gamma at any beta, since B = 1/(1 + pi_8 - A).
struct Dpc : Porous {
  bool published_flow = false;

  static constexpr std::string_view name = "dpc";
  static const CardSection<Dpc>& card();
  static constexpr double A = 0.02; ///< pi_8/cos(pi_6)

  /// s = -p on line and arc, from -Lambda to pi_3; on the cap s - pi_3 is b times its angle, to b pi/2.
  struct Surface {
    Dual Lambda, Gamma, pi_3, b; ///< b: p-semi-axis of the cap
    bool published_flow;

    double s_min() const { return -Lambda.x; }
    double s_max() const { return pi_3.x + b.x * std::numbers::pi / 2; }

    SurfacePoint at(double s_) const {
      const Dual s{s_, 1, 0};
      if (s.x > pi_3.x) {
        const Dual t = (s - pi_3) / b, top = Gamma / B();
        return point(-pi_3 - b * sin(t), top * cos(t), -top * sin(t), b * cos(t));
      }
      const Dual tan_b = tan_beta(), from_peak = pi_3 - s; // p + pi_3
      const Dual q = from_peak.x > arc_end() ? (Lambda + s) * tan_b : arc(from_peak);
      const Dual dilating = published_flow ? from_peak : s.x < 0 ? -s * ((Lambda + pi_3) / Lambda) : Dual{};
      return point(-s, q, dilating * tan_b * tan_b, B() * B() * q);
    }
    bool contains(double p, double q) const {
      const double from_peak = p + pi_3.x, y = q * B().x / Gamma.x;
      if (from_peak < 0) return from_peak * from_peak / (b.x * b.x) + y * y <= 1;
      return q <= (from_peak > arc_end() ? (Lambda.x - p) * tan_beta().x : arc({from_peak}).x);
    }
    double first_guess(double p, double q, const Moduli&) const {
      if (p >= -pi_3.x) return -std::min(p, 0.9 * Lambda.x);
      const double angle = std::acos(std::min(q * B().x / Gamma.x, 0.99));
      return pi_3.x + b.x * std::min(angle, -(p + pi_3.x) / b.x);
    }
    /// The paper tells two zones apart, since its line dilates everywhere.
    Zone zone(double s) const {
      return s > pi_3.x ? Zone::compaction : s < 0 && !published_flow ? Zone::tension : Zone::shear;
    }

   private:
    Dual tan_beta() const { return Gamma / (Lambda + pi_3); }
    Dual cos_beta() const { return 1 / sqrt(1 + tan_beta() * tan_beta()); }
    Dual B() const { return 1 / (1 - A + A * cos_beta()); }
    /// p + pi_3 where the arc meets the line: pi_8 Gamma sin(beta).
    double arc_end() const {
      const double t = tan_beta().x;
      return A * Gamma.x * t / (1 + t * t);
    }
    Dual arc(Dual from_peak) const {
      const Dual radius = A * (cos_beta() * Gamma);
      return (1 - A) * Gamma + sqrt(radius * radius - from_peak * from_peak);
    }
    static SurfacePoint point(Dual p, Dual q, Dual m_p, Dual m_q) {
      const Dual length = sqrt(m_p * m_p + m_q * m_q), n_p = m_p / length, n_q = m_q / length;
      return {p.x, q.x, p.s, q.s, p.phi, q.phi, n_p.x, n_q.x, n_p.s, n_q.s, n_p.phi, n_q.phi};
    }
  };

  /// The same numbers on this surface, whose cap must be shorter than sigma_y.
  static Dpc through(const Porous& m, bool published_flow = false) { return {m, published_flow}; }
  bool cap_fits() const { return epsilon * Gamma < sigma_y; }

  Properties<Surface> properties(double phi) const {
    const auto [m, f] = evolved<Strengths>(phi);
    return {m,
            {{f.Lambda, 0, f.Lambda_phi},
             {f.Gamma, 0, f.Gamma_phi},
             {f.pi_3, 0, f.pi_3_phi},
             {f.b, 0, f.b_phi},
             published_flow}};
  }
  Surface surface(double phi) const { return properties(phi).surface; }
};

} // namespace platen::material
