// Functions of several numbers at a time against those of one.

#include "core/float_traps.hpp"
#include "platen/lanes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace platen::core {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity(),
                 nan = std::numeric_limits<double>::quiet_NaN();

template <class V> class LanesOf : public testing::Test {};
using Kinds = testing::Types<Four, Lanes>;
TYPED_TEST_SUITE(LanesOf, Kinds);

template <class V> V random(std::mt19937_64& generator, double low, double high) {
  std::uniform_real_distribution<double> between(low, high);
  V x;
  for (int i = 0; i < lanes<V>; ++i) x[i] = between(generator);
  return x;
}

TYPED_TEST(LanesOf, ExpLogAndRootAreAsGoodAsTheyClaim) {
  std::mt19937_64 generator(3);
  for (const double size : {1e-12, 1e-4, 1.0, 30.0, 700.0})
    for (int n = 0; n < 20000; ++n) {
      const TypeParam x = random<TypeParam>(generator, -size, size), y = exp(x), near_1 = 1 + x / 710,
                      back = log(y), beside = log(near_1), root = sqrt(y);
      for (int i = 0; i < lanes<TypeParam>; ++i) {
        ASSERT_NEAR(y[i] / std::exp(x[i]), 1, 5e-16) << x[i];
        ASSERT_NEAR(back[i], std::log(y[i]), 7e-16 * std::abs(std::log(y[i]))) << y[i];
        ASSERT_NEAR(beside[i], std::log(near_1[i]), 7e-16 * std::abs(std::log(near_1[i]))) << near_1[i];
        ASSERT_EQ(root[i], std::sqrt(y[i]));
      }
    }
}

TYPED_TEST(LanesOf, ExpHoldsAtItsBoundsAndLogIsOfPositiveNumbersAlone) {
  const NoFloatTraps of_what_is_asked_here;
  TypeParam x{};
  x[0] = 1e4, x[1] = -inf, x[2] = nan;
  const TypeParam e = exp(x);
  EXPECT_NEAR(e[0] / std::exp(708), 1, 5e-16);
  EXPECT_NEAR(e[1] / std::exp(-708), 1, 5e-16);
  EXPECT_TRUE(std::isnan(e[2]));
  EXPECT_EQ(e[3], 1);
  for (const double none : {0.0, -1.0, inf, nan, 1e-310}) {
    const TypeParam l = log(TypeParam{} + none);
    EXPECT_TRUE(std::isnan(l[0])) << none;
  }
}

TYPED_TEST(LanesOf, PickTakesWhereTheMaskHolds) {
  TypeParam x{};
  x[0] = -1, x[1] = 1;
  const TypeParam picked = pick(x < 0, -x, TypeParam{} + 7);
  EXPECT_EQ(picked[0], 1);
  EXPECT_EQ(picked[1], 7);
  EXPECT_TRUE(any(x < 0));
  EXPECT_FALSE(any(x > 1));
}

} // namespace
} // namespace platen::core
