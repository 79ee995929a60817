#include "study/ward.hpp"

#include "study/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using namespace platen::study;

namespace {

using Clusters = std::vector<std::vector<std::size_t>>;

double sum_of_squares(const std::vector<CubePoint>& points, const std::vector<std::size_t>& cluster) {
  double sum = 0;
  for (std::size_t l = 0; l < points[0].size(); ++l) {
    double mean = 0;
    for (const auto i : cluster) mean += points[i][l] / static_cast<double>(cluster.size());
    for (const auto i : cluster) sum += (points[i][l] - mean) * (points[i][l] - mean);
  }
  return sum;
}

/// As Ward defines it: of all pairs the one whose union adds least, again and again.
Clusters by_definition(const std::vector<CubePoint>& points, std::size_t wanted) {
  Clusters clusters;
  for (std::size_t i = 0; i < points.size(); ++i) clusters.push_back({i});
  while (clusters.size() > wanted) {
    double least = std::numeric_limits<double>::infinity();
    std::size_t first = 0, second = 0;
    for (std::size_t i = 0; i < clusters.size(); ++i)
      for (std::size_t j = i + 1; j < clusters.size(); ++j) {
        auto both = clusters[i];
        both.insert(both.end(), clusters[j].begin(), clusters[j].end());
        const double added = sum_of_squares(points, both) - sum_of_squares(points, clusters[i]) -
                             sum_of_squares(points, clusters[j]);
        if (added < least) least = added, first = i, second = j;
      }
    clusters[first].insert(clusters[first].end(), clusters[second].begin(), clusters[second].end());
    clusters.erase(clusters.begin() + static_cast<std::ptrdiff_t>(second));
  }
  for (auto& cluster : clusters) std::sort(cluster.begin(), cluster.end());
  std::sort(clusters.begin(), clusters.end());
  return clusters;
}

} // namespace

TEST(Ward, FindsTheGroupsThatAreThere) {
  const std::vector<CubePoint> points = {{0.1, 0.1}, {0.9, 0.9}, {0.12, 0.1}, {0.9, 0.88}, {0.5, 0.1}};
  EXPECT_EQ(ward(points, 3), (Clusters{{0, 2}, {1, 3}, {4}}));
}

TEST(Ward, GivesWhatTheDefinitionGives) {
  Random random(7);
  for (int repeat = 0; repeat < 20; ++repeat) {
    std::vector<CubePoint> points(25, CubePoint(3));
    for (auto& point : points)
      for (auto& x : point) x = random.uniform();
    for (const std::size_t wanted : {1, 2, 5, 12, 25})
      EXPECT_EQ(ward(points, wanted), by_definition(points, wanted)) << repeat << ", " << wanted;
  }
}
