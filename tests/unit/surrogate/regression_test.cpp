#include "surrogate/regression.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace platen::surrogate {
namespace {

TEST(Monomials, AreAllProductsUpToADegree) {
  const std::array x = {2.0, 3.0};
  EXPECT_EQ(monomials(x, 2), (std::vector<double>{1, 2, 4, 6, 3, 9}));
  EXPECT_EQ(monomial_names({"x", "y"}, 2), (std::vector<std::string>{"1", "x", "x x", "x y", "y", "y y"}));
}

/// 1, x, y, x y and one that has nothing to do with it, at 60 places; y = 2 - 3 x + x y and a little noise.
struct Example {
  std::vector<std::vector<double>> columns = std::vector<std::vector<double>>(5);
  std::vector<double> y;

  Example() {
    for (int i = 0; i < 60; ++i) {
      const double x = std::fmod(0.7548776662 * i, 1.0), z = std::fmod(0.5698402910 * i, 1.0);
      for (const auto& [k, value] : {std::pair{0, 1.0}, {1, x}, {2, z}, {3, x * z}, {4, std::sin(9.0 * i)}})
        columns[static_cast<std::size_t>(k)].push_back(value);
      y.push_back(2 - 3 * x + x * z + 1e-3 * std::sin(37.0 * i));
    }
  }
};

TEST(Stepwise, FindsTheTermsThatAreThere) {
  const Example e;
  auto chosen = stepwise(e.columns, e.y);
  std::sort(chosen.begin(), chosen.end());
  EXPECT_EQ(chosen, (std::vector<std::size_t>{0, 1, 3}));
}

TEST(RegressionLeftOut, DoesNotSeeWhatIsLeftOut) {
  Example e;
  std::vector<std::size_t> groups;
  for (std::size_t i = 0; i < e.y.size(); ++i) groups.push_back(i / 3);
  const auto before = regression_left_out(e.columns, e.y, groups);
  for (std::size_t i = 0; i < e.y.size(); ++i) EXPECT_NEAR(before[i], e.y[i], 5e-3);
  for (std::size_t i = 30; i < 33; ++i) e.y[i] += 100;
  const auto after = regression_left_out(e.columns, e.y, groups);
  for (std::size_t i = 30; i < 33; ++i) EXPECT_NEAR(after[i], before[i], 1e-9);
  EXPECT_GT(std::abs(after[0] - before[0]), 0.1);
}

} // namespace
} // namespace platen::surrogate
