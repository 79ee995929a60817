#include "fit/smooth.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace platen {
namespace {

std::vector<double> uneven_abscissae() {
  std::vector<double> x;
  for (int i = 0; i < 60; ++i) x.push_back(0.01 * i + 0.002 * (i % 3));
  return x;
}

TEST(Smooth, AQuadraticIsItsOwnSmoothOnUnevenSteps) {
  const auto x = uneven_abscissae();
  std::vector<double> y;
  for (const double t : x) y.push_back(1 + 2 * t - 3 * t * t);
  EXPECT_LT(fit::deviation_from_smooth(x, y, 0), 1e-13);
}

// The nine-point quadratic (Savitzky and Golay 1964) gives its middle point the weight 59/231.
TEST(Smooth, ASingleSpikeDeviatesByTheWeightOfSavitzkyAndGolay) {
  std::vector<double> x, y;
  for (int i = 0; i < 30; ++i) {
    x.push_back(0.01 * i);
    y.push_back(1);
  }
  y[15] += 0.01;
  const double smooth = 1 + 0.01 * 59 / 231;
  EXPECT_NEAR(fit::deviation_from_smooth(x, y, 0), (1.01 - smooth) / smooth, 1e-12);
  EXPECT_NEAR(fit::deviation_from_smooth(x, y, 0.151), (0.01 * 54 / 231) / (1 + 0.01 * 54 / 231), 1e-12);
  EXPECT_EQ(fit::deviation_from_smooth(x, y, 0.28), 0); // no point there has four neighbours on either side
}

} // namespace
} // namespace platen
