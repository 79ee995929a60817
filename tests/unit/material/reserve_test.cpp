// How far a stress is from yield.

#include "material/reserve.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace platen;

TEST(StressReserve, IsStrengthOverStressInUniaxialCompression) {
  const double sigma_c = 10e6;
  const std::array<double, 3> half = {0, 0, -sigma_c / 2};
  EXPECT_NEAR(material::stress_reserve(material::VonMises{1e9, 0.3, sigma_c}, half, 0), 2, 1e-8);
  const double phi_deg = 30,
               cohesion = sigma_c * (1 - std::sin(std::acos(-1) / 6)) / 2 / std::cos(std::acos(-1) / 6);
  EXPECT_NEAR(
      material::stress_reserve(material::MohrCoulomb{1e9, 0.3, phi_deg, cohesion, phi_deg, 1e6}, half, 0), 2,
      1e-8);
  const double beta_deg = 40;
  EXPECT_NEAR(
      material::stress_reserve(material::DruckerPrager{1e9, 0.3, beta_deg, sigma_c, beta_deg}, half, 0), 2,
      1e-8);
}

TEST(StressReserve, HasNoEndWhereNothingYields) {
  EXPECT_TRUE(std::isinf(material::stress_reserve(material::Elastic{1e9, 0.3}, {0, 0, -1e6}, 0)));
  EXPECT_TRUE(std::isinf(material::stress_reserve(material::VonMises{1e9, 0.3, 1e6}, {-1e6, -1e6, -1e6}, 0)));
  EXPECT_EQ(material::stress_reserve(material::VonMises{1e9, 0.3, 1e6}, {0, 0, -2e6}, 0), 0);
}
