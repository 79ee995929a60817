#include "study/ward.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace platen::study {
namespace {

struct Cluster {
  CubePoint centroid;
  double size = 1;
};

/// What joining two adds to the sum of squares.
double cost(const Cluster& a, const Cluster& b) {
  double square = 0;
  for (std::size_t l = 0; l < a.centroid.size(); ++l)
    square += (a.centroid[l] - b.centroid[l]) * (a.centroid[l] - b.centroid[l]);
  return a.size * b.size / (a.size + b.size) * square;
}

struct Join {
  std::size_t a, b; ///< a point of either
  double cost;
};

/// All joins. A cluster that is the nearest of its own nearest stays so whatever else is joined, so joins
/// are found in another order than by cost.
std::vector<Join> joins(std::span<const CubePoint> points) {
  std::vector<Cluster> clusters;
  for (const auto& point : points) clusters.push_back({point, 1});
  std::vector<std::size_t> active(points.size());
  std::iota(active.begin(), active.end(), 0);
  std::vector<std::size_t> chain;
  std::vector<Join> result;
  while (active.size() > 1) {
    if (chain.empty()) chain.push_back(active.front());
    const std::size_t top = chain.back();
    const bool has_before = chain.size() > 1;
    std::size_t nearest = has_before ? chain[chain.size() - 2] : top;
    double least =
        has_before ? cost(clusters[top], clusters[nearest]) : std::numeric_limits<double>::infinity();
    for (const std::size_t i : active)
      if (i != top)
        if (const double c = cost(clusters[top], clusters[i]); c < least) least = c, nearest = i;
    if (!has_before || nearest != chain[chain.size() - 2]) {
      chain.push_back(nearest);
      continue;
    }
    chain.resize(chain.size() - 2);
    result.push_back({nearest, top, least});
    auto &kept = clusters[nearest], &gone = clusters[top];
    for (std::size_t l = 0; l < kept.centroid.size(); ++l)
      kept.centroid[l] =
          (kept.size * kept.centroid[l] + gone.size * gone.centroid[l]) / (kept.size + gone.size);
    kept.size += gone.size;
    std::erase(active, top);
  }
  return result;
}

} // namespace

std::vector<std::vector<std::size_t>> ward(std::span<const CubePoint> points, std::size_t wanted) {
  auto list = joins(points);
  std::stable_sort(list.begin(), list.end(), [](const Join& a, const Join& b) { return a.cost < b.cost; });
  std::vector<std::size_t> parent(points.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (std::size_t i = 0; i + wanted < points.size(); ++i) {
    const auto [low, high] = std::minmax({root(list[i].a), root(list[i].b)});
    parent[high] = low;
  }
  std::vector<std::vector<std::size_t>> clusters;
  std::vector<std::size_t> number(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (root(i) == i) {
      number[i] = clusters.size();
      clusters.emplace_back();
    }
    clusters[number[root(i)]].push_back(i);
  }
  return clusters;
}

} // namespace platen::study
