#pragma once

#include "material/plasticity.hpp"

#include <algorithm>
#include <cmath>

namespace platen::material {

/// von Mises Double Cap (Edmans & Sinka, Table 2, eqs 3a-5b). phi = -eps_v^p, rho_r = rho_r0 e^phi.
///
///   tension     (p/Lambda)^2 + (q/Gamma)^2 = 1                        p > 0
///   shear       q = Gamma                                             0 >= p >= -pi_3
///   compaction  ((p + pi_3)/(sigma_y - pi_3))^2 + (q/Gamma)^2 = 1     p < -pi_3,  pi_3 = sigma_y - epsilon
///   Gamma
///
/// associated flow. sigma_y, E, Gamma, Lambda grow as exp(k (rho_r - rho_r0)), nu and epsilon linearly.
/// Bounds, reported in `bounds`: beyond rho_r = 1 the properties are those at 1; nu in [0, nu_max]; epsilon
/// at least epsilon_min; pi_3 at least 0 (the printed definition of epsilon in ES Table 3 is inverted; this
/// is the reading in which it is p-semi-axis over q-semi-axis).
struct Vmdc {
  double rho_r0;  ///< relative density of the undeformed material, in (0, 1]
  double sigma_y; ///< hydrostatic yield stress in compression (Pa), > 0
  double E;       ///< Young's modulus (Pa), > 0
  double nu;      ///< Poisson's ratio, in [0, 0.5)
  double Gamma;   ///< shear strength, largest q (Pa), > 0
  double Lambda;  ///< tensile strength, largest p (Pa), > 0
  double epsilon; ///< p-semi-axis over q-semi-axis of the compaction cap, > 0
  double eta;     ///< exponent of sigma_y
  double xi;      ///< exponent of E
  double zeta;    ///< exponent of Gamma
  double omega;   ///< exponent of Lambda
  double xi_1;    ///< slope of nu over rho_r
  double xi_2;    ///< slope of epsilon over rho_r

  static constexpr PhiRate phi_rate{-1, 0};
  static constexpr double nu_max = 0.49;
  static constexpr double epsilon_min = 0.05;

  /// Along s the point moves in p at unit rate where the pieces meet, so that the curve is C1 in s:
  /// tension s in [-2 Lambda, 0], shear [0, pi_3], compaction [pi_3, pi_3 + 2b], b = sigma_y - pi_3. On a cap
  /// s is twice the semi-axis times the tangent of half the angle: no trigonometry.
  struct Surface {
    double Lambda, Gamma, pi_3, b;
    double Lambda_phi, Gamma_phi, pi_3_phi, b_phi;

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

  double rho_r(double phi) const { return rho_r0 * std::exp(phi); }

  /// Moduli and surface share the density.
  Properties<Surface> properties(double phi) const {
    const Density d = density(phi);
    return {moduli(d), surface(d)};
  }
  Moduli moduli(double phi) const { return moduli(density(phi)); }
  Surface surface(double phi) const { return surface(density(phi)); }

  Bounds bounds(double phi) const {
    const Density d = density(phi);
    const double nu_ = nu + xi_1 * d.change, epsilon_ = epsilon + xi_2 * d.change;
    return {d.rho > 1, nu_ > nu_max || nu_ < 0, epsilon_ < epsilon_min, surface(phi).pi_3 <= 0};
  }

 private:
  struct Density {
    double rho;        ///< rho_r, unbounded
    double change;     ///< min(rho_r, 1) - rho_r0: the properties are functions of this
    double change_phi; ///< its derivative
  };
  Density density(double phi) const {
    const double rho = rho_r(phi);
    return {rho, std::min(rho, 1.0) - rho_r0, rho < 1 ? rho : 0};
  }

  Moduli moduli(const Density& d) const {
    const double E_ = E * std::exp(xi * d.change), E_phi = xi * d.change_phi; // relative to E_
    double nu_ = nu + xi_1 * d.change, nu_phi = xi_1 * d.change_phi;
    if (nu_ > nu_max) nu_ = nu_max, nu_phi = 0;
    if (nu_ < 0) nu_ = 0, nu_phi = 0;
    Moduli m = isotropic_moduli(E_, nu_);
    m.K_phi = m.K * (E_phi + 2 * nu_phi / (1 - 2 * nu_));
    m.G_phi = m.G * (E_phi - nu_phi / (1 + nu_));
    return m;
  }

  Surface surface(const Density& d) const {
    // Their exponents are often the same.
    const double by_eta = std::exp(eta * d.change),
                 by_zeta = zeta == eta ? by_eta : std::exp(zeta * d.change),
                 by_omega = omega == eta ? by_eta : std::exp(omega * d.change);
    const double sigma_y_ = sigma_y * by_eta, sigma_y_phi = eta * d.change_phi * sigma_y_;
    Surface f{};
    f.Gamma = Gamma * by_zeta;
    f.Gamma_phi = zeta * d.change_phi * f.Gamma;
    f.Lambda = Lambda * by_omega;
    f.Lambda_phi = omega * d.change_phi * f.Lambda;
    double epsilon_ = epsilon + xi_2 * d.change, epsilon_phi = xi_2 * d.change_phi;
    if (epsilon_ < epsilon_min) epsilon_ = epsilon_min, epsilon_phi = 0;
    f.b = epsilon_ * f.Gamma;
    f.b_phi = epsilon_phi * f.Gamma + epsilon_ * f.Gamma_phi;
    if (f.b > sigma_y_) f.b = sigma_y_, f.b_phi = sigma_y_phi;
    f.pi_3 = sigma_y_ - f.b;
    f.pi_3_phi = sigma_y_phi - f.b_phi;
    return f;
  }
};

} // namespace platen::material
