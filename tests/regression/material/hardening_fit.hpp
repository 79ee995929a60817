#pragma once
// Ludwik and Hollomon hardening beside each other, by least squares over a range of strain (Shahin,
// sections 2.1 and 3.1, after Harthong et al.).

#include "material/hardening.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace platen::material {

inline constexpr int samples = 3000;

struct Sample {
  double strain, stress; ///< total or plastic strain, Pa
};

/// The exponent in (0, 1) with the least misfit: best of a grid, then by golden section about it.
template <class Misfit> double best_exponent(Misfit misfit) {
  constexpr int grid = 100;
  int best = 1;
  for (int i = 2; i < grid; ++i)
    if (misfit(1.0 * i / grid) < misfit(1.0 * best / grid)) best = i;
  double a = (best - 1.0) / grid + 1e-9, b = (best + 1.0) / grid;
  constexpr double golden = 1 / std::numbers::phi;
  for (int i = 0; i < 60; ++i) {
    const double c = b - golden * (b - a), d = a + golden * (b - a);
    (misfit(c) < misfit(d) ? b : a) = misfit(c) < misfit(d) ? d : c;
  }
  return (a + b) / 2;
}

/// sigma = kappa eps^e: kappa for a given e, and what is left of the sum of squares.
struct PowerFit {
  double kappa, left;
};
inline PowerFit fit_power(const std::vector<Sample>& points, double e) {
  double ss = 0, sp = 0, pp = 0;
  for (const auto& [strain, stress] : points) {
    const double power = std::pow(strain, e);
    ss += stress * stress, sp += stress * power, pp += power * power;
  }
  return {sp / pp, ss - sp * sp / pp};
}

/// sigma = sigma_y + K eps^e for a given e, with sigma_y >= 0.
struct OffsetFit {
  double sigma_y, K, left;
};
inline OffsetFit fit_offset(const std::vector<Sample>& points, double e) {
  double n = 0, s = 0, p = 0, ss = 0, sp = 0, pp = 0;
  for (const auto& [strain, stress] : points) {
    const double power = std::pow(strain, e);
    n += 1, s += stress, p += power, ss += stress * stress, sp += stress * power, pp += power * power;
  }
  const double K = (n * sp - s * p) / (n * pp - p * p), sigma_y = (s - K * p) / n;
  if (sigma_y < 0) return {0, sp / pp, ss - sp * sp / pp};
  return {sigma_y, K, ss - sigma_y * s - K * sp};
}

/// The Hollomon law nearest to sigma = sigma_y + K eps_p^{1/n}, eps_p = eps - sigma/E, in the least squares
/// of the stress over total strains evenly spread in (0, strain_max].
inline Hollomon fit_hollomon(const Ludwik& law, double sigma_y, double E, double strain_max) {
  std::vector<Sample> points;
  for (int i = 1; i <= samples; ++i) {
    const double eps = strain_max * i / samples;
    // sigma = E (eps - eps_p) meets the law: bisection, since sigma falls and the law rises with eps_p.
    double low = 0, high = eps;
    for (int k = 0; k < 100; ++k) {
      const double middle = (low + high) / 2;
      (yield_stress(law, E, sigma_y, middle).value < E * (eps - middle) ? low : high) = middle;
    }
    points.push_back({eps, E * (eps - low)});
  }
  const double e = best_exponent([&](double trial) { return fit_power(points, trial).left; });
  return {fit_power(points, e).kappa, e};
}

struct LudwikFit {
  double sigma_y; ///< Pa
  Ludwik law;
};

/// The Ludwik law nearest to sigma = kappa eps^{1/m}, eps_p = eps - sigma/E, over the same strains, from the
/// intersection with the elastic line on. sigma_y >= 0.
inline LudwikFit fit_ludwik(const Hollomon& law, double E, double strain_max) {
  const double eps_y = initial_yield_stress(law, E, 0) / E;
  std::vector<Sample> points;
  for (int i = 1; i <= samples; ++i) {
    const double eps = strain_max * i / samples, sigma = law.kappa * std::pow(eps, law.inverse_m);
    if (eps > eps_y) points.push_back({eps - sigma / E, sigma});
  }
  const double e = best_exponent([&](double trial) { return fit_offset(points, trial).left; });
  const OffsetFit fit = fit_offset(points, e);
  return {fit.sigma_y, {fit.K, e}};
}

} // namespace platen::material
