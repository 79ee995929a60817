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

struct Trial {
  std::array<double, 3> eps;
  double phi;
};

/// A stress inside the surface at a random density, plus an increment of random size up to `increment_max`.
inline Trial random_trial(const Vmdc& m, std::mt19937& generator, double increment_max) {
  std::uniform_real_distribution<double> unit(0, 1), sign(-1, 1);
  Trial trial{{}, -0.5 + 0.85 * unit(generator)};
  const auto surface = m.surface(trial.phi);
  const Moduli moduli = m.moduli(trial.phi);
  const SurfacePoint f = surface.at(surface.s_min() + (surface.s_max() - surface.s_min()) * unit(generator));
  const double inside = unit(generator), lode = 2 * 3.14159265358979 * unit(generator);
  const double size = increment_max * std::pow(10, -3 * unit(generator));
  for (int A = 0; A < 3; ++A)
    trial.eps[A] =
        inside * (f.p / (3 * moduli.K) + f.q / (3 * moduli.G) * std::cos(lode + 2.0943951023932 * A)) +
        size * sign(generator);
  return trial;
}

inline PointUpdate update_one(const Model& model, const std::array<double, 3>& eps, double phi) {
  PointUpdate out{};
  (void)update(model, {&eps, 1}, {&phi, 1}, {&out, 1});
  return out;
}

} // namespace platen::material::testing
