// Hertz for the tests of the local press.
#pragma once

#include "press/press.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace platen::test {

inline press::Case elastic_case(const press::Local& e) {
  return {{"elastic", material::Elastic{10e9, 0.3}}, 0.1, e};
}

inline press::Local to_force(double force_max_N) {
  press::Local e;
  e.force_max_N = force_max_N;
  return e;
}

/// Radius, peak pressure and approach of the loading branch within 0.5 % of Hertz where a/R >= 0.002; returns
/// the number of points that were compared. Radius and pressure are of the deformed surface, which in Hertz's
/// field has shrunk: u_r(a)/a = -(1-2nu)(1+nu)p0/(3E), and in area by (1-2nu)(1+nu)p0/E at the centre
/// (Johnson, Contact Mechanics, 3.41a, 3.42).
inline int expect_hertz(const press::Curve& curve) {
  const double R = curve.radius_m, E = curve.E_Pa, nu = curve.nu;
  int compared = 0;
  for (const auto& point : curve.points) {
    const double a = std::cbrt(3 * point.force_N * R * (1 - nu * nu) / (4 * E));
    if (a < 0.002 * R || point.branch != press::Branch::loading) continue;
    const double p0 = 1.5 * point.force_N / (std::numbers::pi * a * a);
    const double shrunk = (1 - 2 * nu) * (1 + nu) * p0 / E;
    EXPECT_NEAR(point.contact_radius_m / (a * (1 - shrunk / 3)), 1, 0.005) << a / R;
    EXPECT_NEAR(point.peak_pressure_Pa / (p0 * (1 + shrunk)), 1, 0.005) << a / R;
    EXPECT_NEAR(point.hertz_delta_m / (a * a / R), 1, 0.005) << a / R;
    ++compared;
  }
  return compared;
}

} // namespace platen::test
