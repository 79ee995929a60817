// The local press against Hertz, at loads that take seconds. The long range is in local_slow_test.cpp.

#include "hertz.hpp"
#include "press/press.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace platen;

TEST(LocalPress, OfAnElasticSphereIsHertz) {
  const auto result = press::press(test::elastic_case(test::to_force(10)));
  ASSERT_FALSE(result.failure) << *result.failure;
  EXPECT_GT(test::expect_hertz(result.curve), 15);
  EXPECT_FALSE(result.axis);
}

TEST(LocalPress, MeetsTheForcesThatItIsAskedFor) {
  press::Local e = test::to_force(3);
  e.unload_from_N = {2};
  e.fields_at_N = {1, 3};
  e.reload = true;
  const auto result = press::press(test::elastic_case(e));
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

TEST(LocalPress, EndsAtAnOverlapOrAForceWhicheverIsFirst) {
  press::Local e = test::to_force(std::numeric_limits<double>::infinity());
  e.edges = 10;
  e.delta_bar_max = 1e-5;
  e.fields_at = {4e-6};
  e.unload_from_N = {1};
  e.unload_from = {1e-5};
  const auto result = press::press(test::elastic_case(e));
  ASSERT_FALSE(result.failure) << *result.failure;
  EXPECT_EQ(press::loading_end(result.curve)->delta_bar, 1e-5);
  EXPECT_EQ(result.curve.points.back().branch_id, 2);
  ASSERT_EQ(result.snapshots.size(), 1u);
  EXPECT_EQ(result.snapshots[0].delta_bar, 4e-6);
  e.force_max_N = 1;
  EXPECT_NEAR(press::loading_end(press::press(test::elastic_case(e)).curve)->force_N, 1, 1e-4);
}

TEST(LocalPress, YieldsAtTheContactEdgeWhereHertzSaysSo) {
  // sqrt J2 = (1 - 2 nu) p0/3 and I1 = 0 at the edge (Johnson 3.43): 7.663 N for the first row of WG Table 3,
  // and in proportion to the cube of the strength. The sphere's own curvature adds a term of first order in
  // a/R (2.3 % at a/R = 0.004), so the material is a tenth as strong.
  press::Local e = test::to_force(9e-3);
  e.first_contact_bar = 1.5e-4;
  press::Case c = test::elastic_case(e);
  const double beta = material::DruckerPrager::beta_of_friction(25);
  c.material = {"weak", material::DruckerPrager{10e9, 0.15, beta, 1.5e6, beta}};
  const auto result = press::press(c);
  ASSERT_TRUE(result.edge);
  EXPECT_NEAR(result.edge->force_N, 7.663e-3, 0.02 * 7.663e-3);
}
