#include "study/spread.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace platen::study;

TEST(Spread, OfThreePointsByHand) {
  const std::vector<CubePoint> points = {{0, 0}, {0.3, 0.4}, {1, 0.5}};
  const std::vector<std::string> words = {"a", "b", "a"};
  const auto spread_of = spread(points, words);
  EXPECT_DOUBLE_EQ(spread_of.min_distance, 0.5);
  EXPECT_DOUBLE_EQ(spread_of.min_distance_within, std::sqrt(1.25));
  const double terms = 1 / (0.09 * 0.16) + 1 / (1 * 0.25) + 1 / (0.49 * 0.01);
  EXPECT_NEAR(spread_of.maxpro, std::sqrt(terms / 3), 1e-12 * spread_of.maxpro);
}

TEST(Spread, IsInfiniteWhereTwoShareACoordinate) {
  EXPECT_TRUE(std::isinf(spread(std::vector<CubePoint>{{0.2, 0.1}, {0.2, 0.9}}).maxpro));
}

TEST(Spread, OfOnePointIsNone) {
  EXPECT_EQ(spread(std::vector<CubePoint>{{0.5}}).maxpro, 0);
  EXPECT_EQ(spread({}).min_distance, 0);
}
