// The local press over its range: Hertz, and first yield of Drucker-Prager materials where Wang et al.
// (8)-(11) put it.

#include "../press/hertz.hpp"
#include "fit/wang.hpp"
#include "platen/law/drucker_prager_yield.hpp"
#include "press/press.hpp"

#include <gtest/gtest.h>

#include <random>

using namespace platen;

TEST(LocalPressSlow, OfAnElasticSphereIsHertzUpToFivePerCentOfTheRadius) {
  const auto result = press::press(test::elastic_case(test::to_force(18000))); // a/R = 0.05
  ASSERT_FALSE(result.failure) << *result.failure;
  EXPECT_GT(test::expect_hertz(result.curve), 60);
}

TEST(LocalPressSlow, OfAnElasticSphereFitsToTheElasticLimitOfWang) {
  press::Local e = test::to_force(1200);
  e.unload_from_N = {1200};
  auto result = press::press(test::elastic_case(e));
  ASSERT_FALSE(result.failure) << *result.failure;
  result.curve.phi_deg = 25; // any strength: it only sets the unit
  result.curve.sigma_c_Pa = 15e6;
  const auto fit = fit::fit_wang(result.curve);
  EXPECT_NEAR(fit.a, 1, 0.005);
  EXPECT_NEAR(fit.b, 1.5, 0.005);
  ASSERT_EQ(fit.unloading.size(), 1u);
  EXPECT_NEAR(fit.unloading[0].m, 1, 0.005);
  EXPECT_NEAR(fit.unloading[0].n, 1.5, 0.005);
  EXPECT_NEAR(fit.unloading[0].delta_res_m, 0, 1e-3 * fit.delta_y_m);
}

TEST(LocalPressSlow, YieldsOnTheAxisWhereHertzsFieldReachesTheSurface) {
  struct Row {
    double E, nu, phi_deg, sigma_c;
  };
  std::vector<Row> rows = {{10e9, 0.15, 25, 15e6}, {10e9, 0.25, 35, 25e6}}; // WG Table 3
  std::mt19937 random(1);
  const auto within = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int i = 0; i < 10; ++i)
    rows.push_back({within(10e9, 30e9), within(0.1, 0.3), within(20, 40), within(5e6, 50e6)});
  for (const auto& [E, nu, phi_deg, sigma_c] : rows) {
    const auto yield = law::drucker_prager_yield(nu, phi_deg, sigma_c);
    const double beta = material::DruckerPrager::beta_of_friction(phi_deg);
    const material::Material row{"row", material::DruckerPrager{E, nu, beta, sigma_c, beta}};
    const double E_star = E / (1 - nu * nu), R = 0.1;
    const double F_y = std::pow(std::numbers::pi * yield.p0, 3) * R * R / (6 * E_star * E_star);
    const double a_y = std::numbers::pi * yield.p0 / (2 * E_star);
    press::Local e;
    e.force_max_N = 1.3 * F_y;
    e.first_contact_bar = std::min(0.002, 0.5 * a_y);
    const auto result = press::press({row, R, e});
    ASSERT_FALSE(result.failure) << *result.failure;
    ASSERT_TRUE(result.axis);
    EXPECT_NEAR(result.axis->force_N / F_y, 1, 0.02) << "nu " << nu << " phi " << phi_deg;
    EXPECT_NEAR(result.axis->depth_over_a / yield.u, 1, 0.10) << "nu " << nu << " phi " << phi_deg;
  }
}
