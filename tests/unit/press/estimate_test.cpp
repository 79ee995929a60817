// The error that a press estimates of itself.

#include "press/estimate.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace platen;

TEST(Estimate, CoversTheDistanceToAFinerMesh) {
  press::Simple e;
  e.delta_bar_max = 0.05;
  e.elements = 600;
  const press::Case c{{"", material::VonMises{100e6, 0.3, 1e6}, {}}, 1e-3, e};
  const auto result = press::press(c);
  const auto error = press::estimate_error(c, result);
  ASSERT_TRUE(error);
  EXPECT_GT(error->force, 0);
  EXPECT_LT(error->force, 0.2);
  EXPECT_LT(error->coarse_elements, error->elements);
  e.elements = 2500;
  const auto finer = press::press({c.material, 1e-3, e});
  const double deviation = result.curve.points.back().force_N / finer.curve.points.back().force_N - 1;
  EXPECT_LT(std::abs(deviation), error->force);
}

TEST(Estimate, CoarsensEveryExperimentAndAsksForNothingElse) {
  press::Simple simple;
  simple.unload_from = {0.1};
  simple.fields_at = {0.1};
  press::Local local;
  for (const press::Experiment& e :
       {press::Experiment(simple), press::Experiment(local), press::Experiment(press::Die{}),
        press::Experiment(press::Hydrostatic{}), press::Experiment(press::Triaxial{})}) {
    const press::Case coarse = press::coarser({{"", material::Elastic{1e9, 0.3}, {}}, 1e-3, e});
    if (const auto* path = press::by_overlap(coarse.experiment)) {
      EXPECT_LT(path->elements, press::by_overlap(e)->elements);
      EXPECT_TRUE(path->unload_from.empty() && path->fields_at.empty());
    }
    if (const auto* small = std::get_if<press::Local>(&coarse.experiment)) { EXPECT_EQ(small->edges, 10); }
  }
}
