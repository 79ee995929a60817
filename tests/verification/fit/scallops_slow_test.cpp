// A force curve must be smooth: contact that grows by whole elements leaves scallops in it.

#include "fit/smooth.hpp"
#include "press/simple.hpp"

#include <gtest/gtest.h>

using namespace platen;

TEST(ForceCurve, StaysNearItsNinePointSmooth) {
  press::Case c;
  c.material = {"von Mises", material::VonMises{100e6, 0.3, 1e6}};
  const auto result = press::simple(c);
  ASSERT_FALSE(result.failure) << *result.failure;
  std::vector<double> x, y;
  for (const auto& row : result.curve.points) {
    x.push_back(row.delta_bar);
    y.push_back(row.F_bar);
  }
  ASSERT_GT(x.size(), 60u);
  const double worst = fit::deviation_from_smooth(x, y, 0.02);
  std::printf("force within %.2f %% of its smooth\n", 100 * worst);
  // Aimed at is 0.5 %. From 0.3 on the contact grows by whole elements, four steps each (also with flow of
  // first order).
  EXPECT_LT(worst, 0.009);
}
