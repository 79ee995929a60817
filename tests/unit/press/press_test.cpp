#include "press/press.hpp"

#include "core/error.hpp"

#include <gtest/gtest.h>

using namespace platen;

namespace {

/// A picture of the end of a small press.
template <class X> press::Result pressed(X e, double end) {
  e.fields_at = {end};
  return press::press({{"e", material::Elastic{1e9, 0.3}, {}}, 1e-3, e});
}

} // namespace

TEST(Press, GivesWhatTheExperimentKnows) {
  press::Simple simple;
  simple.delta_bar_max = 0.001;
  simple.elements = 200;
  const auto section = pressed(simple, 0.001);
  EXPECT_EQ(section.curve.experiment, "simple");
  EXPECT_EQ(section.snapshots.size(), 1u);
  EXPECT_TRUE(section.spatial.empty() && section.profiles.empty());

  press::Local local;
  local.delta_bar_max = 0.001;
  local.edges = 8;
  const auto small = pressed(local, 0.001);
  EXPECT_EQ(small.curve.experiment, "local");
  EXPECT_EQ(small.snapshots.size(), 1u);
  EXPECT_EQ(small.profiles.size(), 1u);

  press::Die die;
  die.delta_bar_max = 0.001;
  die.elements = 200;
  const auto wedge = pressed(die, 0.001);
  EXPECT_EQ(wedge.curve.experiment, "die");
  EXPECT_EQ(wedge.spatial.size(), 1u);
  EXPECT_TRUE(wedge.snapshots.empty());
}

TEST(Press, RefusesACaseOutsideItsRange) {
  press::Simple e;
  e.delta_bar_max = 0.6;
  EXPECT_THROW(press::press({{"e", material::Elastic{1e9, 0.3}, {}}, 1e-3, e}), core::InvalidInput);
}

TEST(Press, StopsWhereTheCallbackSaysSo) {
  press::Simple e;
  e.delta_bar_max = 0.01;
  e.elements = 100;
  int rows = 0;
  const auto result = press::press({{"e", material::Elastic{1e9, 0.3}, {}}, 1e-3, e},
                                   [&](double, const press::CurvePoint&) { return ++rows < 3; });
  EXPECT_TRUE(result.interrupted);
  EXPECT_FALSE(result.failure);
  EXPECT_EQ(result.curve.points.size(), 3u);
}
