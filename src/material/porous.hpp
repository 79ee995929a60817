#pragma once

#include "material/plasticity.hpp"

#include <algorithm>
#include <cmath>

namespace platen::material {

/// What the von Mises Double Cap and the Drucker-Prager Cap have in common (Edmans & Sinka, Tables 2 and 3):
/// their parameters, and how these evolve with density. phi = -eps_v^p, rho_r = rho_r0 e^phi.
///
/// sigma_y, E, Gamma, Lambda grow as exp(k (rho_r - rho_r0)), nu and epsilon linearly. Bounds, reported in
/// `bounds`: beyond rho_r = 1 the properties are those at 1; nu in [0, nu_max]; epsilon at least epsilon_min;
/// pi_3 at least 0 (the printed definition of epsilon in ES Table 3 is inverted; this is the reading in which
/// it is p-semi-axis over q-semi-axis).
struct Porous {
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

  /// Strengths at one phi with their derivatives, as they shape a surface.
  template <class T> struct StrengthsOf {
    T Lambda, Gamma, pi_3, b; ///< pi_3 = sigma_y - b, b = epsilon Gamma: centre and p-semi-axis of the cap
    T Lambda_phi, Gamma_phi, pi_3_phi, b_phi;
  };
  using Strengths = StrengthsOf<double>;

  double reference_stress() const { return sigma_y; }

  template <class T> T rho_r(T phi) const {
    using std::exp, core::exp;
    return rho_r0 * exp(phi);
  }

  /// Moduli and strengths share the density. S: strengths, or a surface made of them (a copy would cost).
  template <class S, class T> Properties<S, T> evolved(T phi) const {
    const DensityOf<T> d = density(phi);
    return {moduli(d), strengths<S>(d)};
  }
  Moduli moduli(double phi) const { return moduli(density(phi)); }
  template <class S = Strengths> S strengths(double phi) const { return strengths<S>(density(phi)); }

  Bounds bounds(double phi) const {
    const Density d = density(phi);
    const double nu_ = nu + xi_1 * d.change, epsilon_ = epsilon + xi_2 * d.change;
    return {d.rho > 1, nu_ > nu_max || nu_ < 0, epsilon_ < epsilon_min, strengths<Strengths>(d).pi_3 <= 0};
  }

 private:
  template <class T> struct DensityOf {
    T rho;        ///< rho_r, unbounded
    T change;     ///< min(rho_r, 1) - rho_r0: the properties are functions of this
    T change_phi; ///< its derivative
  };
  using Density = DensityOf<double>;
  template <class T> DensityOf<T> density(T phi) const {
    using core::pick;
    const T rho = rho_r(phi), one = T{} + 1;
    return {rho, pick(rho < 1, rho, one) - rho_r0, pick(rho < 1, rho, T{})};
  }

  template <class T> ModuliOf<T> moduli(const DensityOf<T>& d) const {
    using std::exp, core::exp, core::pick;
    const T E_ = E * exp(xi * d.change), E_phi = xi * d.change_phi; // relative to E_
    T nu_ = nu + xi_1 * d.change;
    const auto bounded = core::either(nu_ > nu_max, nu_ < 0);
    const T nu_phi = pick(bounded, T{}, xi_1 * d.change_phi);
    nu_ = pick(nu_ > nu_max, T{} + nu_max, pick(nu_ < 0, T{}, nu_));
    ModuliOf<T> m = isotropic_moduli(E_, nu_);
    m.K_phi = m.K * (E_phi + 2 * nu_phi / (1 - 2 * nu_));
    m.G_phi = m.G * (E_phi - nu_phi / (1 + nu_));
    return m;
  }

  template <class S, class T> S strengths(const DensityOf<T>& d) const {
    using std::exp, core::exp, core::pick;
    // Their exponents are often the same.
    const T by_eta = exp(eta * d.change), by_zeta = zeta == eta ? by_eta : exp(zeta * d.change),
            by_omega = omega == eta ? by_eta : exp(omega * d.change);
    const T sigma_y_ = sigma_y * by_eta, sigma_y_phi = eta * d.change_phi * sigma_y_;
    S f{};
    f.Gamma = Gamma * by_zeta;
    f.Gamma_phi = zeta * d.change_phi * f.Gamma;
    f.Lambda = Lambda * by_omega;
    f.Lambda_phi = omega * d.change_phi * f.Lambda;
    T epsilon_ = epsilon + xi_2 * d.change;
    const auto least = epsilon_ < epsilon_min;
    const T epsilon_phi = pick(least, T{}, xi_2 * d.change_phi);
    epsilon_ = pick(least, T{} + epsilon_min, epsilon_);
    f.b = epsilon_ * f.Gamma;
    f.b_phi = epsilon_phi * f.Gamma + epsilon_ * f.Gamma_phi;
    const auto centred = f.b > sigma_y_;
    f.b = pick(centred, sigma_y_, f.b);
    f.b_phi = pick(centred, sigma_y_phi, f.b_phi);
    f.pi_3 = sigma_y_ - f.b;
    f.pi_3_phi = sigma_y_phi - f.b_phi;
    return f;
  }
};

} // namespace platen::material
