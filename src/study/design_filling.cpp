// Fast flexible filling: design.hpp.

#include "core/error.hpp"
#include "study/design.hpp"
#include "study/random.hpp"
#include "study/ward.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace platen::study {
namespace {

using Clusters = std::vector<std::vector<std::size_t>>;

/// The point at a place in the cube; `category` is the level of the factor with values.
Point point_at(const std::vector<Factor>& factors, const CubePoint& place, const Level& category) {
  Point point;
  std::size_t l = 0;
  for (const auto& factor : factors) {
    if (!factor.values.empty()) point.push_back(category);
    else {
      const double u = place[l++];
      point.emplace_back(factor.log ? factor.min * std::pow(factor.max / factor.min, u)
                                    : factor.min + u * (factor.max - factor.min));
    }
  }
  return point;
}

/// Clusters of points of one cluster.
Clusters ward_within(const std::vector<CubePoint>& points, const std::vector<std::size_t>& members,
                     std::size_t k) {
  std::vector<CubePoint> own;
  for (const auto i : members) own.push_back(points[i]);
  auto clusters = ward(own, k);
  for (auto& cluster : clusters)
    for (auto& i : cluster) i = members[i];
  return clusters;
}

std::size_t nearest_to_centroid(const std::vector<CubePoint>& points,
                                const std::vector<std::size_t>& cluster) {
  CubePoint centroid(points[0].size(), 0.0);
  for (const auto i : cluster)
    for (std::size_t l = 0; l < centroid.size(); ++l)
      centroid[l] += points[i][l] / static_cast<double>(cluster.size());
  std::size_t nearest = cluster.front();
  double least = std::numeric_limits<double>::infinity();
  for (const auto i : cluster) {
    double square = 0;
    for (std::size_t l = 0; l < centroid.size(); ++l)
      square += (points[i][l] - centroid[l]) * (points[i][l] - centroid[l]);
    if (square < least) least = square, nearest = i;
  }
  return nearest;
}

/// One point of each cluster: from those nearest to the centroids, one after another is exchanged for the
/// member that makes the MaxPro criterion smallest, until none can be.
std::vector<std::size_t> choose(const std::vector<CubePoint>& points, const Clusters& clusters) {
  std::vector<std::size_t> chosen;
  for (const auto& cluster : clusters) chosen.push_back(nearest_to_centroid(points, cluster));
  const auto with_others = [&](std::size_t c, std::size_t i) {
    double sum = 0;
    for (std::size_t other = 0; other < chosen.size(); ++other)
      if (other != c) sum += maxpro_term(points[i], points[chosen[other]]);
    return sum;
  };
  constexpr int sweeps = 100; // the sum falls with each exchange, so it ends; it takes some ten
  bool moved = true;
  for (int sweep = 0; moved && sweep < sweeps; ++sweep) {
    moved = false;
    for (std::size_t c = 0; c < clusters.size(); ++c) {
      double least = with_others(c, chosen[c]);
      for (const auto i : clusters[c])
        if (const double sum = with_others(c, i); sum < least) least = sum, chosen[c] = i, moved = true;
    }
  }
  return chosen;
}

} // namespace

std::vector<Point> space_filling(const std::vector<Factor>& factors, std::size_t runs, std::uint64_t seed,
                                 const std::function<bool(const Point&)>& admissible) {
  const auto category = std::find_if(factors.begin(), factors.end(),
                                     [](const Factor& factor) { return !factor.values.empty(); });
  const std::vector<Level> levels = category == factors.end() ? std::vector<Level>{0.0} : category->values;
  const std::size_t k = levels.size(), ranges = factors.size() - (category != factors.end());
  if (runs % k != 0)
    throw core::InvalidInput(fmt::format(
        "runs = {} cannot be shared out evenly among the {} values of '{}'; give a multiple of {}", runs, k,
        category->name, k));

  Random random(seed);
  const std::size_t wanted = std::min<std::size_t>(50 * runs, 20000);
  std::vector<CubePoint> points;
  for (std::size_t tried = 0; points.size() < wanted; ++tried) {
    if (tried >= 1000 && points.size() * 1000 < tried)
      throw core::InvalidInput(
          "[bounds] admit less than a thousandth of the ranges of [factors]; narrow these");
    CubePoint place;
    for (std::size_t l = 0; l < ranges; ++l) place.push_back(random.uniform());
    if (std::all_of(levels.begin(), levels.end(),
                    [&](const Level& level) { return admissible(point_at(factors, place, level)); }))
      points.push_back(std::move(place));
  }

  Clusters clusters;
  for (const auto& primary : ward(points, runs / k)) {
    if (primary.size() < k)
      throw core::InvalidInput("a cluster has fewer points than values to share out; give another seed");
    for (auto& cluster : ward_within(points, primary, k)) clusters.push_back(std::move(cluster));
  }
  const auto chosen = choose(points, clusters);
  std::vector<Point> design;
  std::vector<std::size_t> order(k); // the k clusters of one primary cluster stand together
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (i % k == 0) {
      std::iota(order.begin(), order.end(), 0);
      random.shuffle(order);
    }
    design.push_back(point_at(factors, points[chosen[i]], levels[order[i % k]]));
  }
  return design;
}

} // namespace platen::study
