#include "press/tension.hpp"

#include <gtest/gtest.h>

using namespace platen;
using press::Branch;

namespace {

void add(press::Curve& curve, int branch_id, Branch branch, double delta_bar, double sigma_1_Pa) {
  press::CurvePoint point;
  point.branch_id = branch_id;
  point.branch = branch;
  point.delta_bar = delta_bar;
  point.sigma_1_max_Pa = sigma_1_Pa;
  curve.points.push_back(point);
}

/// Tension rises to 3 Pa at 0.3 and falls; a branch from 0.2 reaches 5 Pa while it unloads.
press::Curve curve() {
  press::Curve curve;
  for (const auto& [delta_bar, sigma] : {std::pair{0.1, 1.0}, {0.2, 2.0}, {0.3, 3.0}, {0.4, 1.0}})
    add(curve, 0, Branch::loading, delta_bar, sigma);
  add(curve, 1, Branch::unloading, 0.2, 2);
  add(curve, 1, Branch::unloading, 0.18, 5);
  return curve;
}

} // namespace

TEST(Tension, IsLargestWhereTheCurveSaysSo) {
  const auto largest = press::largest_tension(curve());
  EXPECT_EQ(largest.sigma_1_Pa, 5);
  EXPECT_EQ(largest.delta_bar, 0.18);
  EXPECT_EQ(largest.branch, Branch::unloading);
  EXPECT_EQ(largest.branch_id, 1);
  EXPECT_EQ(press::largest_tension({}).sigma_1_Pa, 0);
}

TEST(Tension, ReachesAStrengthBetweenTwoRows) {
  EXPECT_NEAR(press::fracture(curve(), 2.5)->delta_bar, 0.25, 1e-15);
  EXPECT_NEAR(press::fracture(curve(), 0.5)->delta_bar, 0.05, 1e-15); // from rest
  EXPECT_EQ(press::fracture(curve(), 3)->delta_bar, 0.3);
  EXPECT_FALSE(press::fracture(curve(), 5.1));
}

TEST(Tension, ReachesAStrengthInABranchOnlyWhereLoadingDidNot) {
  const auto first = press::fracture(curve(), 3.5);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->branch, Branch::unloading);
  EXPECT_NEAR(first->delta_bar, 0.19, 1e-15);
  EXPECT_EQ(press::fracture(curve(), 2.5)->branch, Branch::loading);
}

TEST(Tension, IsSaidInASentence) {
  EXPECT_EQ(press::tension_words(curve(), {}), "largest tension 5 Pa at delta_bar = 0.18 while unloading");
  EXPECT_EQ(
      press::tension_words(curve(), 2.5),
      "largest tension 5 Pa at delta_bar = 0.18 while unloading; it reaches the tensile strength, 2.5 Pa, at "
      "delta_bar = 0.25: the particle may crack there");
  EXPECT_EQ(press::tension_words(curve(), 6),
            "largest tension 5 Pa at delta_bar = 0.18 while unloading; below the tensile strength, 6 Pa");
  EXPECT_EQ(press::tension_words({}, {}), "no tension anywhere");
}
