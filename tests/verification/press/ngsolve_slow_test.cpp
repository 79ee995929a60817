// Perfectly plastic metals against codes whose elements do not lock: NGSolve's Taylor-Hood triangles for
// E/sigma_y = 100 (docs/explanation/what-can-be-trusted.md; meshes, steps and penetration extrapolated, force
// uncertain by 0.3 %, 0.5 % below 0.03, radius by 0.4 %, 0.5 % up to 0.1), and a code of Q1/P0 and Q2/P1
// elements with 112 edges under the contact and steps to zero for E/sigma_y = 500 (0.4 and 1 %).

#include "press/press.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace platen;

namespace {

struct Reference {
  double delta_bar, F_bar, a_bar;
};

void expect_near(double E_bar, const std::vector<Reference>& references) {
  press::Simple e;
  e.delta_bar_max = references.back().delta_bar;
  for (const auto& r : references) e.fields_at.push_back(r.delta_bar); // the curve has rows there
  const auto result = press::press({{"", material::VonMises{E_bar * 1e6, 0.3, 1e6}, {}}, 1, e});
  ASSERT_FALSE(result.failure) << *result.failure;
  for (const auto& r : references) {
    const press::CurvePoint* row = nullptr;
    for (const auto& point : result.curve.points)
      if (point.delta_bar == r.delta_bar) row = &point;
    ASSERT_TRUE(row) << r.delta_bar;
    const double force = 100 * (row->F_bar / r.F_bar - 1),
                 radius = 100 * (row->contact_radius_m / r.a_bar - 1);
    std::printf("E/sigma_y %.0f, delta_bar %.2f: force %+.2f %%, radius %+.2f %%\n", E_bar, r.delta_bar,
                force, radius);
    EXPECT_LT(std::abs(force), 1) << r.delta_bar;
    EXPECT_LT(std::abs(radius), 1) << r.delta_bar;
  }
}

} // namespace

TEST(VonMisesOutside, ForceAndRadiusAreThoseOfNGSolve) {
  expect_near(100, {{0.01, 0.0338, 0.1212},
                    {0.02, 0.0798, 0.1810},
                    {0.03, 0.1283, 0.2290},
                    {0.05, 0.2245, 0.3052},
                    {0.1, 0.4297, 0.4432},
                    {0.15, 0.5400, 0.5293},
                    {0.2, 0.6115, 0.5934},
                    {0.25, 0.6809, 0.6539},
                    {0.3, 0.7539, 0.7088},
                    {0.35, 0.8402, 0.7690},
                    {0.4, 0.9405, 0.8342},
                    {0.45, 1.0551, 0.9020},
                    {0.5, 1.1864, 0.9765}});
}
TEST(VonMisesOutside, ForceAndRadiusOfAStiffMetalAreThoseOfAnIndependentCode) {
  expect_near(500, {{0.01, 0.0598, 0.148},
                    {0.02, 0.1223, 0.216},
                    {0.03, 0.1809, 0.268},
                    {0.05, 0.2871, 0.348},
                    {0.1, 0.4792, 0.481}});
}
