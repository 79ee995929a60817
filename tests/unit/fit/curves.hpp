#pragma once
// Curves made from formulas, for the tests of fits.

#include "platen/law/edmans_sinka_curve.hpp"
#include "press/curve.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace platen::test {

/// Loading branch of `points` even steps to delta_bar_max, after (0, 0).
inline press::Curve loading_curve(const std::function<double(double)>& F_bar, int points = 200,
                                  double delta_bar_max = 0.5) {
  press::Curve curve;
  curve.radius_m = 1e-3;
  curve.sigma_ref_Pa = 150e6;
  curve.E_Pa = 15e9;
  curve.nu = 0.3;
  curve.experiment = "simple";
  for (int i = 0; i <= points; ++i) {
    press::CurvePoint point;
    point.delta_bar = delta_bar_max * i / points;
    point.delta_m = point.delta_bar * curve.radius_m;
    point.F_bar = F_bar(point.delta_bar);
    point.force_N = point.F_bar * std::numbers::pi * curve.radius_m * curve.radius_m * curve.sigma_ref_Pa;
    curve.points.push_back(point);
  }
  return curve;
}

inline law::EdmansSinkaCurve<double> edmans_sinka(double k, double delta_t, double a,
                                                  law::EdmansSinkaVariant variant) {
  law::EdmansSinkaCurve<double> law;
  law.k = k;
  law.delta_t = delta_t;
  law.a = a;
  law.variant = variant;
  return law;
}

/// F_bar multiplied by 1 + noise times a normal deviate; the same for the same seed.
inline press::Curve noisy(press::Curve curve, double noise, unsigned seed) {
  std::mt19937 bits(seed);
  std::normal_distribution<double> normal;
  for (auto& point : curve.points) point.F_bar *= 1 + noise * normal(bits);
  return curve;
}

/// Adds an unloading branch of the form (13), `points` steps of which the last two are past separation.
inline void add_unloading(press::Curve& curve, int branch_id, double delta_bar_max, double F_bar_max,
                          double alpha, double delta_bar_0, int points = 30) {
  for (int i = 0; i <= points; ++i) {
    press::CurvePoint point;
    point.branch = press::Branch::unloading;
    point.branch_id = branch_id;
    point.delta_bar = delta_bar_max - (delta_bar_max - delta_bar_0) * i / (points - 2);
    const double share = (point.delta_bar - delta_bar_0) / (delta_bar_max - delta_bar_0);
    point.F_bar = share > 0 ? F_bar_max * std::pow(share, alpha) : 0;
    curve.points.push_back(point);
  }
}

} // namespace platen::test
