#include "platen/law/fast_power.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using namespace platen::law;

TEST(FastPower, AgreesWithTheLibrary) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> u(0, 1);
  for (int i = 0; i < 1'000'000; ++i) {
    const double x = std::pow(10, -12 * u(random) * u(random)), e = 16 * u(random),
                 y = 1400 * u(random) - 700;
    ASSERT_NEAR(detail::fast_power(x, e) / std::pow(x, e), 1, 5e-13) << x << ' ' << e;
    ASSERT_NEAR(detail::fast_exp(y) / std::exp(y), 1, 1e-13) << y;
  }
  EXPECT_EQ(detail::fast_power(1, 3.3), 1);
  EXPECT_EQ(detail::fast_power(1e-300, 16), 0);
}

} // namespace
