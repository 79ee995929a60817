#pragma once
// Random admissible states and increments of a plastic model.

#include "material/update.hpp"

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace platen::material::testing {

/// The corners and the middle of Edmans & Sinka's parameter space (section 3.5) around their base case (Table
/// 6).
inline std::vector<Vmdc> corner_materials() {
  std::vector<Vmdc> all;
  for (const double E_bar : {3.0, 100.0, 500.0})
    for (const double Gamma_bar : {0.25, 1.0})
      for (const double Lambda_bar : {0.01, 1.0})
        all.push_back({0.7, 1, E_bar, 0.3, Gamma_bar, Lambda_bar, 0.7, 10, 7.5, 10, 10, 0.4, 1.5});
  return all;
}

/// Metals with every kind of hardening; stresses in units of about the yield stress.
inline std::vector<VonMises> metals() {
  const auto hollomon = [](double E, double kappa, double inverse_m) {
    const Hollomon h{kappa, inverse_m};
    return VonMises{E, 0.3, initial_yield_stress(h, E, 0), h};
  };
  return {{100, 0.3, 1},
          {100, 0.3, 1, ExponentialHardening{2}},
          {100, 0.3, 1, ExponentialHardening{-0.5}},
          hollomon(1000, 1, 0.25),
          hollomon(1000, 1, 0.99996),          // Shahin, Table E.1, die, last row
          {2000, 0.435, 1, Ludwik{3.1, 0.35}}, // his lead with a yield stress in its units
          {1000, 0.3, 1, Ludwik{2, 1.5}},
          {1000, 0.3, 1, HardeningTable{{0, 0.01, 0.1, 0.5}, {1, 1.4, 1.8, 1.7}}}};
}

/// Wang et al., Table 1, its middle row, associated and not; stresses in units of sigma_c.
inline std::vector<DruckerPrager> rocks() {
  const double beta = DruckerPrager::beta_of_friction(30);
  return {
      {1000, 0.2, beta, 1, beta}, {1000, 0.2, beta, 1, 10}, {1000, 0.2, beta, 1, 0}, {1000, 0.2, 5, 1, 5}};
}

/// Drucker-Prager Caps through the points of the corner materials whose cap is shorter than sigma_y.
inline std::vector<Dpc> caps(bool published_flow = false) {
  std::vector<Dpc> all;
  for (const auto& m : corner_materials()) all.push_back(Dpc::through(m, published_flow));
  return all;
}

/// Wang et al., section 3.4, item (b), in units of C; associated and not; without dilation; Tresca.
inline std::vector<MohrCoulomb> rocks_by_mohr() {
  return {{1e4 / 3.2, 0.38, 27.8, 1, 27.8, 1 / 3.2},
          {1e4 / 3.2, 0.38, 27.8, 1, 5, 1 / 3.2},
          {100, 0.2, 40, 1, 0, 1},
          {100, 0.3, 0, 1, 0, 0.5}};
}

struct Trial {
  std::array<double, 3> eps;
  double phi;
};

/// A place on the surface; where that goes on without end, at a pressure of the size of the strength.
template <class Surface> double random_place(const Surface& f, double unit) {
  return f.s_min() + (f.s_max() - f.s_min()) * unit;
}
inline double random_place(const VonMises::Surface& f, double unit) { return f.sigma_y * (6 * unit - 3); }
inline double random_place(const DruckerPrager::Surface& f, double unit) { return f.d * (6 * unit - 1); }

/// The states at which a material is looked at.
template <class M> std::array<double, 2> states(const M&) { return {-0.5, 0.35}; }
inline std::array<double, 2> states(const VonMises&) { return {0, 0.35}; }

/// A stress inside the surface at a random state, at least `inside_min` of the way to it, or to the largest
/// tension of the elastic law.
template <InvariantModel M> Trial random_state(const M& m, std::mt19937& generator, double inside_min = 0) {
  std::uniform_real_distribution<double> unit(0, 1);
  const auto [first, last] = states(m);
  const double phi = first + (last - first) * unit(generator);
  const auto surface = m.surface(phi);
  const auto [K, G, K_phi, G_phi] = m.moduli(phi);
  const SurfacePoint f = surface.at(random_place(surface, unit(generator)));
  const double reach = std::min(1.0, f.p > 0 ? 0.9 * K / std::exp(1.0) / f.p : 1.0);
  const double inside = reach * (inside_min + (1 - inside_min) * unit(generator));
  const double lode = 2 * 3.14159265358979 * unit(generator);
  const double eps_v = detail::volumetric_strain(inside * f.p, K),
               eps_q = inside * f.q / (3 * G) * std::exp(eps_v);
  Trial state{{}, phi};
  for (int A = 0; A < 3; ++A) state.eps[A] = eps_v / 3 + eps_q * std::cos(lode + 2.0943951023932 * A);
  return state;
}

/// The same plus an increment of random size up to `increment_max`.
template <InvariantModel M> Trial random_trial(const M& m, std::mt19937& generator, double increment_max) {
  std::uniform_real_distribution<double> unit(0, 1), sign(-1, 1);
  Trial trial = random_state(m, generator);
  const double size = increment_max * std::pow(10, -3 * unit(generator));
  for (double& e : trial.eps) e += size * sign(generator);
  return trial;
}

/// (p, q) over the yield surface: 1 on it.
inline double yield_ratio(const Vmdc::Surface& f, double p, double q) {
  const double excess = p > 0 ? p / f.Lambda : p < -f.pi_3 ? (p + f.pi_3) / f.b : 0;
  return std::hypot(excess, q / f.Gamma);
}
inline double yield_ratio(const VonMises::Surface& f, double, double q) { return q / f.sigma_y; }
inline double yield_ratio(const DruckerPrager::Surface& f, double p, double q) {
  return (q + p * f.tan_beta) / f.d;
}

/// Edmans & Sinka's f of Table 2 as printed, with its pi_7 = b/Gamma, in units of Gamma: 0 on the surface.
inline double table_2(const Dpc::Surface& f, double p, double q) {
  const double pi_3 = f.pi_3.x, tan_6 = f.Gamma.x / (f.Lambda.x + pi_3), pi_5 = f.Lambda.x * tan_6;
  const double pi_6 = std::atan(tan_6), pi_7 = f.b.x / f.Gamma.x, pi_8 = Dpc::A * std::cos(pi_6);
  const double A = pi_8 / std::cos(pi_6), B = 1 / (1 + pi_8 - A), C = pi_5 + pi_3 * tan_6;
  const double p_i = pi_3 - pi_8 * C * std::sin(pi_6);
  double value = 0;
  if (p > -p_i) value = q + p * tan_6 - pi_5;
  else if (p >= -pi_3) value = std::hypot(p + pi_3, q - (1 - A) * C) - pi_8 * C;
  else value = (std::hypot(p + pi_3, B * pi_7 * q) - pi_7 * C) / pi_7;
  return value / C;
}
inline double yield_ratio(const Dpc::Surface& f, double p, double q) { return 1 + table_2(f, p, q); }

inline PointUpdate update_one(const Model& model, const std::array<double, 3>& eps, double phi) {
  PointUpdate out{};
  (void)update(model, {&eps, 1}, {&phi, 1}, {&out, 1});
  return out;
}

} // namespace platen::material::testing
