// The default mesh against the value that it and two finer ones tend to, for two metals. The elements halve
// from the first to the last, and the error of a four-node element falls with their square, so the value at
// no size is F_3 + (F_3 - F_1)/3.

#include "press/press.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace platen;

namespace {

const std::vector<double> compared = {0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5};

std::vector<press::CurvePoint> rows_of_mesh(double E_bar, int elements) {
  press::Simple e;
  e.elements = elements;
  e.fields_at = compared;
  const auto result = press::press({{"von Mises", material::VonMises{E_bar * 1e6, 0.3, 1e6}}, 1e-3, e});
  EXPECT_FALSE(result.failure) << *result.failure;
  std::vector<press::CurvePoint> rows;
  for (const double d : compared)
    for (const auto& row : result.curve.points)
      if (row.delta_bar == d) rows.push_back(row);
  return rows;
}

} // namespace

class Convergence : public testing::TestWithParam<double> {};

TEST_P(Convergence, OfTheDefaultMeshIsNearTheLimitOfThreeMeshes) {
  const int elements = press::Simple{}.elements;
  const auto coarse = rows_of_mesh(GetParam(), elements), middle = rows_of_mesh(GetParam(), 2 * elements),
             fine = rows_of_mesh(GetParam(), 4 * elements);
  ASSERT_EQ(coarse.size(), compared.size());
  ASSERT_EQ(middle.size(), compared.size());
  ASSERT_EQ(fine.size(), compared.size());
  for (std::size_t i = 0; i < compared.size(); ++i) {
    const auto error = [&](double press::CurvePoint::*value) {
      const double limit = fine[i].*value + (fine[i].*value - coarse[i].*value) / 3;
      return 100 * (coarse[i].*value / limit - 1);
    };
    const double force = error(&press::CurvePoint::F_bar),
                 radius = error(&press::CurvePoint::contact_radius_m);
    std::printf("E/sigma_y %.0f, delta_bar %.2f: force %+.2f %%, radius %+.2f %%\n", GetParam(), compared[i],
                force, radius);
    EXPECT_LT(std::abs(force), 1.3) << compared[i];
    EXPECT_LT(std::abs(radius), 1.5) << compared[i];
  }
}

INSTANTIATE_TEST_SUITE_P(VonMises, Convergence, testing::Values(100.0, 500.0));
