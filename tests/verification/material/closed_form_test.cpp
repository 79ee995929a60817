// Material points against closed forms.

#include "material/update.hpp"

#include <gtest/gtest.h>

using namespace platen::material;

namespace {

const Vmdc base_case{0.7, 150e6, 15e9, 0.3, 150e6, 1.5e6, 0.7, 10, 7.5, 10, 10, 0.4, 1.5}; // ES Table 6

struct Point {
  std::array<double, 3> elastic{};
  double phi = 0;
  PointUpdate last{};
  void strain(const Model& model, const std::array<double, 3>& increment) {
    std::array<double, 3> trial = elastic;
    for (int A = 0; A < 3; ++A) trial[A] += increment[A];
    const auto counts = update(model, {&trial, 1}, {&phi, 1}, {&last, 1});
    ASSERT_EQ(counts.refused, 0);
    elastic = last.eps;
    phi = last.phi;
  }
};

} // namespace

TEST(ClosedForm, IsotropicCompressionYieldsAtTheHydrostaticStrengthOfItsDensity) {
  // ES (3a), (4a): p = -sigma_y0 exp(eta (rho_r - rho_r0)), rho_r = rho_r0 exp(phi), and phi is the
  // volumetric strain put in less the elastic part.
  Point point;
  const double step = -0.001;
  for (int i = 1; i <= 115; ++i) {
    point.strain(base_case, {step, step, step});
    if (point.last.zone == Zone::elastic) continue;
    const double rho_r = 0.7 * std::exp(point.phi);
    ASSERT_LT(rho_r, 1);
    EXPECT_NEAR(point.last.p, -150e6 * std::exp(10 * (rho_r - 0.7)), 1e-8 * 150e6);
    EXPECT_NEAR(point.last.q, 0, 1e-3 * 150e6);
    const double elastic = point.elastic[0] + point.elastic[1] + point.elastic[2];
    EXPECT_NEAR(point.phi, -(3 * step * i) + elastic, 1e-10);
  }
  EXPECT_EQ(point.last.zone, Zone::compaction);
}

TEST(ClosedForm, IsotropicTensionYieldsAtTheTensileStrengthOfItsDensity) {
  Point point;
  for (int i = 0; i < 100; ++i) point.strain(base_case, {1e-4, 1e-4, 1e-4});
  const double rho_r = 0.7 * std::exp(point.phi);
  EXPECT_EQ(point.last.zone, Zone::tension);
  EXPECT_LT(rho_r, 0.7);
  EXPECT_NEAR(point.last.p, 1.5e6 * std::exp(10 * (rho_r - 0.7)), 1e-6 * 1.5e6);
}

TEST(ClosedForm, ShearAtConstantVolumeYieldsAtTheShearStrengthWithoutChangeOfDensity) {
  Point point;
  // A little pressure first, so that the stress meets the straight part of the surface.
  point.strain(base_case, {-2e-4, -2e-4, -2e-4});
  for (int i = 0; i < 200; ++i) point.strain(base_case, {5e-4, -5e-4, 0});
  EXPECT_EQ(point.last.zone, Zone::shear);
  EXPECT_NEAR(point.last.q, 150e6, 1e-4 * 150e6);
  EXPECT_NEAR(point.phi, 0, 1e-9);
}

TEST(ClosedForm, VonMisesInUniaxialStrainAddsTheElasticPressure) {
  // q = sigma_y, sigma_1 = p - 2/3 sigma_y, p = K e^{-eps_v} eps_v with the whole volume change elastic.
  const double E = 100, nu = 0.3, K = E / (3 * (1 - 2 * nu));
  Point point;
  for (int i = 0; i < 50; ++i) point.strain(VonMises{E, nu, 1}, {-0.001, 0, 0});
  const double eps_v = -0.05, p = K * eps_v * std::exp(-eps_v);
  EXPECT_NEAR(point.last.q, 1, 1e-10);
  EXPECT_NEAR(point.last.sigma[0], p - 2.0 / 3, 1e-10 * K);
}
