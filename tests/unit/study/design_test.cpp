#include "study/design.hpp"

#include "core/error.hpp"
#include "study/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace platen;
using namespace platen::study;

namespace {

Factor range(const std::string& name, double min, double max, bool log = false) {
  Factor factor;
  factor.name = name;
  factor.min = min;
  factor.max = max;
  factor.log = log;
  return factor;
}

Factor list(const std::string& name, std::vector<Level> values) {
  Factor factor;
  factor.name = name;
  factor.values = std::move(values);
  return factor;
}

double number(const Level& level) { return std::get<double>(level); }
bool any_point(const Point&) { return true; }

std::map<std::string, int> counts(const std::vector<Point>& points, std::size_t column) {
  std::map<std::string, int> result;
  for (const auto& point : points) ++result[text_of(point[column])];
  return result;
}

const std::vector<Factor> three_loadings = {list("experiment", {"simple", "die", "hydrostatic"}),
                                            range("x", 2, 200), range("y", 0.2, 0.48), range("z", 1, 500)};

} // namespace

TEST(Factorial, HasEveryCombinationTheLastFactorFastest) {
  const auto points = factorial({list("a", {1.0, 2.0}), list("b", {"x", "y", "z"})});
  ASSERT_EQ(points.size(), 6u);
  EXPECT_EQ(points[1], (Point{1.0, "y"}));
  EXPECT_EQ(points[3], (Point{2.0, "x"}));
}

TEST(LatinHypercube, HasOneRunInEachStratumOfEachRange) {
  const std::size_t n = 17;
  const auto points = latin_hypercube({range("a", 1, 3), range("b", 1, 1000, true)}, n, 4);
  ASSERT_EQ(points.size(), n);
  std::vector<int> a(n), b(n);
  for (const auto& point : points) {
    ++a[static_cast<std::size_t>((number(point[0]) - 1) / 2 * n)];
    ++b[static_cast<std::size_t>(std::log10(number(point[1])) / 3 * n)];
  }
  EXPECT_EQ(a, std::vector<int>(n, 1));
  EXPECT_EQ(b, std::vector<int>(n, 1));
}

TEST(LatinHypercube, SharesValuesOutEvenly) {
  const auto points = latin_hypercube({range("a", 0, 1), list("b", {"x", "y", "z"})}, 30, 1);
  EXPECT_EQ(counts(points, 1), (std::map<std::string, int>{{"x", 10}, {"y", 10}, {"z", 10}}));
}

TEST(LatinHypercube, IsThatOfItsSeed) {
  const std::vector<Factor> factors = {range("a", 0, 1), range("b", 0, 1)};
  EXPECT_EQ(latin_hypercube(factors, 20, 5), latin_hypercube(factors, 20, 5));
  EXPECT_NE(latin_hypercube(factors, 20, 5), latin_hypercube(factors, 20, 6));
}

TEST(SpaceFilling, SharesLevelsOutEvenlyAndStaysInItsRanges) {
  const auto points = space_filling(three_loadings, 51, 1, any_point);
  ASSERT_EQ(points.size(), 51u);
  EXPECT_EQ(counts(points, 0),
            (std::map<std::string, int>{{"simple", 17}, {"die", 17}, {"hydrostatic", 17}}));
  for (const auto& place : in_cube(three_loadings, points, points)) {
    ASSERT_EQ(place.size(), 3u);
    for (const double x : place) EXPECT_TRUE(x >= 0 && x <= 1) << x;
  }
  EXPECT_EQ(points, space_filling(three_loadings, 51, 1, any_point));
  EXPECT_NE(points, space_filling(three_loadings, 51, 2, any_point));
}

TEST(SpaceFilling, SpreadsBetterThanRandomPoints) {
  const auto filled = space_filling(three_loadings, 51, 1, any_point);
  const auto spread_of = spread(in_cube(three_loadings, filled, filled), categories(filled));
  Random random(1);
  for (int repeat = 0; repeat < 20; ++repeat) {
    std::vector<CubePoint> points(51, CubePoint(3));
    for (auto& point : points)
      for (auto& x : point) x = random.uniform();
    EXPECT_LT(spread_of.maxpro, spread(points).maxpro);
    EXPECT_GT(spread_of.min_distance, spread(points).min_distance);
  }
}

TEST(SpaceFilling, HoldsItsBounds) {
  const auto admissible = [](const Point& point) {
    const double lambda = number(point[1]) / number(point[3]);
    return lambda >= 0.1 && lambda <= 6;
  };
  for (const auto& point : space_filling(three_loadings, 30, 3, admissible)) EXPECT_TRUE(admissible(point));
}

TEST(SpaceFilling, WithoutACategoryTakesOnePointOfEachCluster) {
  EXPECT_EQ(space_filling({range("a", 0, 1), range("b", 0, 1)}, 7, 1, any_point).size(), 7u);
}

TEST(SpaceFilling, RefusesWhatCannotBe) {
  EXPECT_THROW(space_filling(three_loadings, 50, 1, any_point), core::InvalidInput); // not a multiple of 3
  EXPECT_THROW(space_filling(three_loadings, 51, 1, [](const Point&) { return false; }), core::InvalidInput);
}

TEST(TableDesign, ConvertsUnitsAndWords) {
  const auto table = core::parse_csv("loading,E_MPa,nu\nhydro,1.1,0.3\nsimple,2,0.2\n", "t.csv");
  Factor loading = list("experiment", {}), E = list("material.E_Pa", {}), nu = list("material.nu", {});
  loading.column = "loading";
  loading.names = {{"hydro", "hydrostatic"}, {"simple", "simple"}};
  E.column = "E_MPa";
  nu.column = "nu";
  EXPECT_EQ(rows_of(table, {loading, E, nu}, {}),
            (std::vector<Point>{{"hydrostatic", 1.1e6, 0.3}, {"simple", 2e6, 0.2}}));
  EXPECT_EQ(rows_of(table, {nu}, {{"loading", "simple"}}), (std::vector<Point>{{0.2}}));
  loading.names.erase("hydro");
  EXPECT_THROW(rows_of(table, {loading}, {}), core::InvalidInput);
  nu.column = "E_MPa";
  EXPECT_THROW(rows_of(table, {nu}, {}), core::InvalidInput);
  nu.column = "mu";
  EXPECT_THROW(rows_of(table, {nu}, {}), core::InvalidInput);
}
