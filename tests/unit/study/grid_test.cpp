#include "study/grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

using namespace platen;
using namespace platen::study;

namespace {

press::CurvePoint at(int id, press::Branch branch, double delta_bar, double F_bar) {
  press::CurvePoint point;
  point.branch_id = id;
  point.branch = branch;
  point.delta_bar = delta_bar;
  point.delta_m = 2 * delta_bar;
  point.F_bar = F_bar;
  point.force_N = F_bar * std::numbers::pi * 4 * 10;
  point.contact_radius_m = 2 * std::sqrt(delta_bar);
  return point;
}

/// Hertz-like loading in steps of 4 %, unloading from 0.1 to 0.04.
press::Curve curve() {
  press::Curve c;
  c.radius_m = 2;
  c.sigma_ref_Pa = 10;
  c.experiment = "simple";
  for (double d = 1e-4; d < 0.1; d *= 1.04)
    c.points.push_back(at(0, press::Branch::loading, d, std::pow(d, 1.5)));
  c.points.push_back(at(0, press::Branch::loading, 0.1, std::pow(0.1, 1.5)));
  for (int i = 0; i < 30; ++i) {
    const double d = 0.1 - 0.002 * i;
    c.points.push_back(at(1, press::Branch::unloading, d, std::pow((d - 0.04) / 0.06, 1.5)));
  }
  for (const double d : {0.04, 0.03}) c.points.push_back(at(1, press::Branch::unloading, d, 0));
  return c;
}

} // namespace

TEST(Interpolation, IsExactOnALineAndAtThePoints) {
  const std::vector<double> x = {0, 1, 3, 4}, line = {1, 3, 7, 9}, any = {0, 5, 4, 8};
  EXPECT_DOUBLE_EQ(interpolate(x, line, 2.2), 5.4);
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_DOUBLE_EQ(interpolate(x, any, x[i]), any[i]);
  const std::vector<double> down = {4, 3, 1, 0}, values = {9, 7, 3, 1};
  EXPECT_DOUBLE_EQ(interpolate(down, values, 2.2), 5.4);
}

TEST(Interpolation, NeverOvershoots) {
  const std::vector<double> x = {0, 1, 2, 3, 4}, step = {0, 0, 1, 1, 0};
  for (double at_x = 0; at_x <= 4; at_x += 0.01) {
    const double y = interpolate(x, step, at_x);
    EXPECT_TRUE(y >= -1e-15 && y <= 1 + 1e-15) << at_x;
  }
}

TEST(Grid, HasMultiplesOfTheStepAndThreePartsOfIt) {
  const auto rows = on_grid(curve(), 0.02);
  const std::vector<double> wanted = {0.0025, 0.005, 0.01, 0.02, 0.04, 0.06, 0.08, 0.1};
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_EQ(rows[i].branch, press::Branch::loading);
    EXPECT_NEAR(rows[i].delta_bar, wanted[i], 1e-15);
    // in steps of 4 % a cubic is good to (0.04)^3
    EXPECT_NEAR(rows[i].z.F_bar / std::pow(wanted[i], 1.5), 1, 1e-4) << wanted[i];
    EXPECT_NEAR(rows[i].z.a_bar / std::sqrt(wanted[i]), 1, 1e-4) << wanted[i];
    EXPECT_FALSE(rows[i].x);
  }
  EXPECT_EQ(rows[wanted.size()].branch, press::Branch::unloading);
}

TEST(Grid, OfAnUnloadingBranchEndsWhereItSeparates) {
  const auto rows = on_grid(curve(), 0.02);
  ASSERT_EQ(rows.size(), 8u + 21u);
  EXPECT_DOUBLE_EQ(rows[8].delta_bar, 0.1);
  EXPECT_NEAR(rows.back().delta_bar, 0.04, 1e-12); // the first zero, not the last
  EXPECT_NEAR(rows[18].delta_bar, 0.07, 1e-12);
  EXPECT_NEAR(rows[18].z.F_bar, std::pow(0.5, 1.5), 1e-4);
}

TEST(Grid, OfAPathThatTurnsIsItsSteps) {
  auto c = curve();
  c.experiment = "triaxial";
  c.points.resize(4);
  c.points.push_back(at(0, press::Branch::loading, 1e-4, 0));
  const auto rows = on_grid(c, 0.02);
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_EQ(rows[3].delta_bar, c.points[3].delta_bar);
  EXPECT_TRUE(rows[0].x && rows[0].y);
}

TEST(Difference, IsTheLargestOfAnyColumn) {
  const auto one = curve();
  EXPECT_EQ(difference(one, one), 0);
  auto other = one;
  for (auto& point : other.points) point.contact_radius_m *= 1.03;
  EXPECT_NEAR(difference(one, other), 0.03, 1e-9);
  auto shorter = one;
  shorter.points.resize(shorter.points.size() - 32);
  EXPECT_EQ(difference(one, shorter), std::numeric_limits<double>::infinity());
  EXPECT_EQ(difference(shorter, one), std::numeric_limits<double>::infinity());
  EXPECT_EQ(difference({}, one), std::numeric_limits<double>::infinity());
  EXPECT_EQ(difference({}, {}), 0);
}
