#pragma once

#include "material/plasticity.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

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
  /// tension s in [-Lambda pi/2, 0], shear [0, pi_3], compaction [pi_3, pi_3 + b pi/2], b = sigma_y - pi_3.
  struct Surface {
    double Lambda, Gamma, pi_3, b;
    double Lambda_phi, Gamma_phi, pi_3_phi, b_phi;

    double s_min() const { return -Lambda * std::numbers::pi / 2; }
    double s_max() const { return pi_3 + b * std::numbers::pi / 2; }

    SurfacePoint at(double s) const {
      if (s < 0) return cap(s / Lambda, Lambda, Lambda_phi, 0, 0);
      if (s <= pi_3) return {-s, Gamma, -1, 0, 0, Gamma_phi, 0, 1, 0, 0, 0, 0};
      return cap((s - pi_3) / b, b, b_phi, pi_3, pi_3_phi);
    }
    bool contains(double p, double q) const {
      const double p_excess = p > 0 ? p / Lambda : p < -pi_3 ? (p + pi_3) / b : 0;
      const double y = q / Gamma;
      return p_excess * p_excess + y * y <= 1;
    }
    /// Keeps q of the trial where a cap allows it: the caps give way volumetrically first.
    double first_guess(double p, double q) const {
      const double angle = std::acos(std::min(q / Gamma, 0.99));
      if (p > 0) return -Lambda * std::min(angle, p / Lambda);
      if (p < -pi_3) return pi_3 + b * std::min(angle, -(p + pi_3) / b);
      return -p;
    }
    Zone zone(double s) const { return s < 0 ? Zone::tension : s <= pi_3 ? Zone::shear : Zone::compaction; }

   private:
    /// Elliptic cap with semi-axes (c, Gamma) about p = -p0: p = -p0 - c sin t, q = Gamma cos t.
    SurfacePoint cap(double t, double c, double c_phi, double p0, double p0_phi) const {
      const double sin_t = std::sin(t), cos_t = std::cos(t);
      const double t_s = 1 / c, t_phi = -(p0_phi + t * c_phi) / c;
      const double p_t = -c * cos_t, q_t = -Gamma * sin_t;
      // The normal (-Gamma sin t, c cos t), made a unit vector by its length h.
      const double n_p = -Gamma * sin_t, n_q = c * cos_t;
      const double h = std::hypot(n_p, n_q);
      const double u = n_p / h, v = n_q / h;
      const auto turned = [&](double dn_p, double dn_q) { return (v * dn_p - u * dn_q) / h; };
      const double turn_t = turned(-Gamma * cos_t, -c * sin_t);
      const double turn_phi = turned(-Gamma_phi * sin_t, c_phi * cos_t) + turn_t * t_phi;
      const double turn_s = turn_t * t_s;
      return {-p0 - c * sin_t,
              Gamma * cos_t,
              p_t * t_s,
              q_t * t_s,
              -p0_phi - c_phi * sin_t + p_t * t_phi,
              Gamma_phi * cos_t + q_t * t_phi,
              u,
              v,
              v * turn_s,
              -u * turn_s,
              v * turn_phi,
              -u * turn_phi};
    }
  };

  double rho_r(double phi) const { return rho_r0 * std::exp(phi); }

  Moduli moduli(double phi) const {
    const Density d = density(phi);
    const double E_ = E * std::exp(xi * d.change), E_phi = xi * d.change_phi * E_;
    double nu_ = nu + xi_1 * d.change, nu_phi = xi_1 * d.change_phi;
    if (nu_ > nu_max) nu_ = nu_max, nu_phi = 0;
    if (nu_ < 0) nu_ = 0, nu_phi = 0;
    Moduli m = isotropic_moduli(E_, nu_);
    m.K_phi = m.K * (E_phi / E_ + 2 * nu_phi / (1 - 2 * nu_));
    m.G_phi = m.G * (E_phi / E_ - nu_phi / (1 + nu_));
    return m;
  }

  Surface surface(double phi) const {
    const Density d = density(phi);
    const auto grown = [&](double initial, double exponent) {
      return initial * std::exp(exponent * d.change);
    };
    const double sigma_y_ = grown(sigma_y, eta), sigma_y_phi = eta * d.change_phi * sigma_y_;
    Surface f{};
    f.Gamma = grown(Gamma, zeta);
    f.Gamma_phi = zeta * d.change_phi * f.Gamma;
    f.Lambda = grown(Lambda, omega);
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
};

} // namespace platen::material
