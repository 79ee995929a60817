// The local press against Hertz, at loads that take seconds. The long range is in local_slow_test.cpp.

#include "hertz.hpp"
#include "press/local.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace platen;

TEST(LocalPress, OfAnElasticSphereIsHertz) {
  const press::Case c = test::elastic_case(10);
  const auto result = press::local(c);
  ASSERT_FALSE(result.failure) << *result.failure;
  EXPECT_GT(test::expect_hertz(result.curve), 15);
  EXPECT_FALSE(result.axis);
}

TEST(LocalPress, MeetsTheForcesThatItIsAskedFor) {
  press::Case c = test::elastic_case(3);
  c.unload_from_N = {2};
  c.fields_at_N = {1, 3};
  c.reload = true;
  const auto result = press::local(c);
  ASSERT_FALSE(result.failure) << *result.failure;
  ASSERT_EQ(result.profiles.size(), 2u);
  EXPECT_EQ(press::profile_name(result.profiles[1]), "profile-3.csv");
  double bottom = 2;
  for (const auto& p : result.curve.points)
    if (p.branch == press::Branch::unloading) bottom = p.force_N;
  EXPECT_LT(bottom, 0.002);
  EXPECT_NEAR(result.curve.points.back().force_N, 2, 2e-3); // reloaded to where it came from
  EXPECT_EQ(result.curve.points.back().branch, press::Branch::reloading);
  // The profile carries the force: pressure over its rings, the outermost free one without.
  for (const auto& profile : result.profiles) EXPECT_EQ(profile.points.back()[1], 0);
  // p0 sqrt(1 - r^2/a^2), within 1 % away from the edge.
  const auto& profile = result.profiles[1];
  const double a = profile.contact_radius_m, p0 = 1.5 * 3 / (std::acos(-1) * a * a);
  for (const auto& [r, p] : profile.points)
    if (r < 0.9 * a) { EXPECT_NEAR(p, p0 * std::sqrt(1 - r * r / (a * a)), 0.01 * p) << r / a; }
}
