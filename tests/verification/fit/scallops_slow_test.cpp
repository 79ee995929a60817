// A force curve must be smooth: contact that grows by whole elements leaves scallops in it.

#include "fit/smooth.hpp"
#include "material/card.hpp"
#include "press/press.hpp"

#include <gtest/gtest.h>

#include <cstdio>

using namespace platen;

namespace {

void expect_smooth(const char* name, const material::Model& model) {
  const auto result = press::press({{name, model}});
  ASSERT_FALSE(result.failure) << *result.failure;
  std::vector<double> x, y;
  for (const auto& row : result.curve.points) {
    x.push_back(row.delta_bar);
    y.push_back(row.F_bar);
  }
  ASSERT_GT(x.size(), 60u);
  const double worst = fit::deviation_from_smooth(x, y, 0.02);
  std::printf("%s: force within %.2f %% of its smooth\n", name, 100 * worst);
  EXPECT_LT(worst, 0.005);
}

} // namespace

TEST(ForceCurve, OfAMetalStaysNearItsNinePointSmooth) {
  for (const double E_bar : {100.0, 500.0}) {
    char name[40];
    std::snprintf(name, sizeof name, "E/sigma_y = %g", E_bar);
    expect_smooth(name, material::VonMises{E_bar * 1e6, 0.3, 1e6});
  }
}
TEST(ForceCurve, OfAGranuleStaysNearItsNinePointSmooth) {
  expect_smooth("base case", material::read_card("base-case").material.model);
}
