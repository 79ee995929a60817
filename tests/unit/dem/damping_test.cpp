// Viscous damping and the restitution it was asked for.

#include "dem/contact_step.hpp"
#include "dem/damping.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace platen::dem {
namespace {

/// Velocity after Hertz's impact F = u^(3/2) of a unit mass at the velocity 1: Runge & Kutta, 4th order.
double rebound(double damping) {
  const auto a = [&](double u, double v) {
    const double at = std::max(u, 0.0),
                 F = damped(damping, {}, 1.5 * std::sqrt(at), at * std::sqrt(at), 1, -v);
    EXPECT_GE(F, 0) << "pulls";
    return -F;
  };
  double u = 0, v = 1;
  for (const double dt = 5e-5; u >= 0 && !(v < 0 && a(u, v) == 0);) { // then it coasts
    const double a1 = a(u, v), v2 = v + dt / 2 * a1, a2 = a(u + dt / 2 * v, v2), v3 = v + dt / 2 * a2,
                 a3 = a(u + dt / 2 * v2, v3), v4 = v + dt * a3, a4 = a(u + dt * v3, v4);
    u += dt / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v += dt / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  return -v;
}

TEST(Damping, ReturnsTheRestitutionAskedForAndNeverPulls) {
  for (const double e : {0.98, 0.9, 0.7, 0.5, 0.3, 0.2, 0.14, 0.13, 0.05, 0.01, 1e-3})
    EXPECT_NEAR(rebound(platen_damping_of(e)), e, 1e-6) << e;
}

TEST(Damping, IsTsujisWhereItIsSmall) { // Tsuji, Tanaka & Ishida 1992: 2 sqrt(5/6) |ln e|/sqrt(ln^2 e + pi^2)
  EXPECT_EQ(platen_damping_of(1), 0);
  for (const double e : {1 - 1e-4, 1 - 1e-6, 1 - 1e-9})
    EXPECT_NEAR(platen_damping_of(e) * std::acos(-1.0) / (2 * std::sqrt(5.0 / 6) * -std::log(e)), 1, 1 - e)
        << e;
}

TEST(Damping, IsThorntonsFitOfImpactsToItsAccuracy) {
  // Thornton, Cummins & Cleary, Powder Technology 233 (2013) 30, Table 2: c = 2 gamma sqrt(m dF/dgamma), no
  // tension
  const double h[] = {-6.918798, -16.41105, 146.8049,  -796.4559, 2928.711,
                      -7206.864, 11494.29,  -11342.18, 6276.757,  -1489.915};
  for (const double e : {0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9}) {
    double sum = 0;
    for (int k = 9; k >= 0; --k) sum = e * (h[k] + sum);
    const double gamma = std::sqrt(1 / (1 - (1 + e) * (1 + e) * std::exp(sum)) - 1);
    EXPECT_NEAR(platen_damping_of(e) / (2 * gamma), 1, 2e-3) << e;
  }
}

TEST(Damping, IsThatOfALinearSpringOfTheSameRatio) { // e = exp(-2 zeta A), also where nobody asks for it
  EXPECT_NEAR(platen_damping_of(std::exp(-2.0)), std::sqrt(10.0 / 3), 1e-12); // critical
  for (double e = 0.9999; e > 1e-300; e *= e > 1e-3 ? 0.99 : 0.1) {
    const double zeta = std::sqrt(0.3) * platen_damping_of(e), r = std::sqrt(std::abs(1 - zeta * zeta));
    const double A = zeta < 1 ? std::acos(zeta) / r : std::acosh(zeta) / r;
    EXPECT_NEAR(2 * zeta * A / -std::log(e), 1, 1e-12) << e;
  }
}

TEST(Damping, HidesNoVelocityThatIsNoNumber) {
  EXPECT_TRUE(std::isnan(damped(0.5, {}, 1e5, 1, 1e-6, std::numeric_limits<double>::quiet_NaN())));
  EXPECT_EQ(damped(0.5, {}, 1e5, 0, 1e-6, std::numeric_limits<double>::quiet_NaN()), 0); // apart
}

} // namespace
} // namespace platen::dem
