// Densification that raises the elastic stress faster than the surface gives way has no state to go to.

#include "random_states.hpp"

#include <gtest/gtest.h>

using namespace platen::material;
using namespace platen::material::testing;

namespace {

/// Soft, with a bulk modulus that grows much faster than its strength.
Vmdc runaway(double xi) { return {0.7, 1, 3, 0.3, 0.5, 0.1, 0.7, 1, xi, 1, 1, 0, 0}; }

/// 1 + (|p|/K_t)(eta rho_r - d(ln K)/d(phi)), |p| = sigma_y(rho_r). K_t = dp/d(eps_v) = K (1 - eps_v)
/// e^{-eps_v} of the finite elastic strain, which is K for stiff materials.
double margin(const Vmdc& m, double phi) {
  const Moduli k = m.moduli(phi);
  const double rho = m.rho_r(phi), p = m.sigma_y * std::exp(m.eta * (rho - m.rho_r0));
  const double eps_v = detail::volumetric_strain(-p, k.K), K_t = k.K * (1 - eps_v) * std::exp(-eps_v);
  return 1 + p / K_t * (m.eta * rho - k.K_phi / k.K);
}

} // namespace

TEST(Stability, IsotropicCompressionIsRefusedWithItsOwnStatusWhereTheModuliRunAway) {
  for (const double xi : {1.0, 3.0, 5.0, 12.0, 20.0}) {
    const Vmdc m = runaway(xi);
    // A yielding state compressed a little further.
    const double eps = -(m.sigma_y / m.moduli(0).K) * 1.2 / 3;
    const PointUpdate u = update_one(m, {eps, eps, eps}, 0);
    const bool expected = margin(m, 0) < 0;
    ASSERT_GT(std::abs(margin(m, 0)), 0.05) << xi;
    EXPECT_EQ(u.status == Status::unstable, expected) << xi;
    EXPECT_EQ(is_refused(u.status), expected) << xi;
  }
}

TEST(Stability, IsCountedApartFromOtherRefusals) {
  const Vmdc m = runaway(12);
  const double eps = -(m.sigma_y / m.moduli(0).K) * 0.4;
  const std::array<double, 3> trial{eps, eps, eps};
  const double phi = 0;
  PointUpdate u{};
  const UpdateCounts counts = update(m, {&trial, 1}, {&phi, 1}, {&u, 1});
  EXPECT_EQ(counts.refused, 1);
  EXPECT_EQ(counts.unstable, 1);
}
