#pragma once

#include "material/porous.hpp"

namespace platen::material {

/// von Mises Double Cap (Edmans & Sinka, Table 2, eqs 3a-5b).
///
///   tension     (p/Lambda)^2 + (q/Gamma)^2 = 1                        p > 0
///   shear       q = Gamma                                             0 >= p >= -pi_3
///   compaction  ((p + pi_3)/(sigma_y - pi_3))^2 + (q/Gamma)^2 = 1     p < -pi_3,  pi_3 = sigma_y - epsilon
///   Gamma
///
/// associated flow.
struct Vmdc : Porous {
  static constexpr std::string_view name = "vmdc";
  static const CardSection<Vmdc>& card();

  /// Along s the point moves in p at unit rate where the pieces meet, so that the curve is C1 in s:
  /// tension s in [-2 Lambda, 0], shear [0, pi_3], compaction [pi_3, pi_3 + 2b], b = sigma_y - pi_3. On a cap
  /// s is twice the semi-axis times the tangent of half the angle: no trigonometry.
  struct Surface : Strengths {
    double s_min() const { return -2 * Lambda; }
    double s_max() const { return pi_3 + 2 * b; }

    SurfacePoint at(double s) const {
      if (s < 0) return cap(s / (2 * Lambda), Lambda, Lambda_phi, 0, 0);
      if (s <= pi_3) return {-s, Gamma, -1, 0, 0, Gamma_phi, 0, 1, 0, 0, 0, 0};
      return cap((s - pi_3) / (2 * b), b, b_phi, pi_3, pi_3_phi);
    }
    bool contains(double p, double q) const {
      const double p_excess = p > 0 ? p / Lambda : p < -pi_3 ? (p + pi_3) / b : 0;
      const double y = q / Gamma;
      return p_excess * p_excess + y * y <= 1;
    }
    /// On a cap the return keeps q where q < Gamma: the caps give way volumetrically first. Beyond, it meets
    /// the cap near its top, where the normal points along what is left of the strain: tan t = c dv/(Gamma
    /// dw).
    double first_guess(double p, double q, const Moduli& m) const {
      const auto on_cap = [&](double excess, double c) {
        const double y = q / Gamma, x = excess / c;
        const auto half_tangent = [](double cos_t) { return std::sqrt((1 - cos_t) / (1 + cos_t)); };
        if (y < 1) return 2 * c * half_tangent(y);
        const double dv = c * excess / m.K, dw = Gamma * (q - Gamma) / (3 * m.G);
        const double u = half_tangent(dw / std::sqrt(dv * dv + dw * dw));
        return 2 * c * (x < 1 ? std::min(u, x / (1 + std::sqrt(1 - x * x))) : u);
      };
      if (p > 0) return -on_cap(p, Lambda);
      if (p < -pi_3) return pi_3 + on_cap(-p - pi_3, b);
      return -p;
    }
    Zone zone(double s) const { return s < 0 ? Zone::tension : s <= pi_3 ? Zone::shear : Zone::compaction; }

   private:
    /// Elliptic cap with semi-axes (c, Gamma) about p = -p0: p = -p0 - c sin t, q = Gamma cos t, u =
    /// tan(t/2).
    SurfacePoint cap(double u, double c, double c_phi, double p0, double p0_phi) const {
      const double t_u = 2 / (1 + u * u), sin_t = u * t_u, cos_t = t_u - 1;
      const double t_s = t_u / (2 * c), t_phi = -(p0_phi + 2 * u * c_phi) * t_s;
      const double p_t = -c * cos_t, q_t = -Gamma * sin_t;
      // The normal (-Gamma sin t, c cos t), made a unit vector by its length.
      const double n_p = -Gamma * sin_t, n_q = c * cos_t;
      const double per_length = 1 / std::sqrt(n_p * n_p + n_q * n_q);
      const double m_p = n_p * per_length, m_q = n_q * per_length;
      const auto turned = [&](double dn_p, double dn_q) { return (m_q * dn_p - m_p * dn_q) * per_length; };
      const double turn_t = turned(-Gamma * cos_t, -c * sin_t);
      const double turn_phi = turned(-Gamma_phi * sin_t, c_phi * cos_t) + turn_t * t_phi;
      const double turn_s = turn_t * t_s;
      return {-p0 - c * sin_t,
              Gamma * cos_t,
              p_t * t_s,
              q_t * t_s,
              -p0_phi - c_phi * sin_t + p_t * t_phi,
              Gamma_phi * cos_t + q_t * t_phi,
              m_p,
              m_q,
              m_q * turn_s,
              -m_p * turn_s,
              m_q * turn_phi,
              -m_p * turn_phi};
    }
  };

  Properties<Surface> properties(double phi) const { return evolved<Surface>(phi); }
  Surface surface(double phi) const { return strengths<Surface>(phi); }
};

} // namespace platen::material
