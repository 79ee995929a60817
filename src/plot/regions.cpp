#include "plot/regions.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>

namespace platen::plot {

namespace {

/// Nodes closer than this to the axis or the equator (in units of R0) lie on it, and are shared by the mirror
/// images.
constexpr double on_symmetry_line = 1e-9;

std::uint64_t edge_key(int from, int to) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(from)) << 32 | static_cast<std::uint32_t>(to);
}

Point middle(const Point& a, const Point& b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2}; }

/// Adds vertices once: corners, and the middles of edges that neighbours share.
class Builder {
 public:
  Patchwork patchwork;

  int add(Point point) {
    patchwork.vertices.push_back(point);
    return static_cast<int>(patchwork.vertices.size()) - 1;
  }
  int middle_of(int a, int b) {
    const auto [entry, is_new] = middles_.try_emplace(edge_key(std::min(a, b), std::max(a, b)), 0);
    if (is_new) entry->second = add(middle(at(a), at(b)));
    return entry->second;
  }
  const Point& at(int vertex) const { return patchwork.vertices[static_cast<std::size_t>(vertex)]; }

 private:
  std::unordered_map<std::uint64_t, int> middles_;
};

double doubled_area(const std::vector<Point>& ring) {
  double sum = 0;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    sum += ring[j].x * ring[i].y - ring[i].x * ring[j].y;
  return sum;
}

/// Boundary edges of the patches of one colour: start vertex → end vertices.
using Edges = std::multimap<int, int>;

/// Angle by which a path that comes along a→b turns left into b→c, in (-pi, pi].
double left_turn(const Point& a, const Point& b, const Point& c) {
  const double ux = b.x - a.x, uy = b.y - a.y, vx = c.x - b.x, vy = c.y - b.y;
  return std::atan2(ux * vy - uy * vx, ux * vx + uy * vy);
}

/// Takes one closed ring out of the edges. Where two patches touch in a vertex it keeps to its own: sharpest
/// left.
std::vector<int> take_ring(Edges& edges, const std::vector<Point>& vertices) {
  const auto point = [&](int vertex) { return vertices[static_cast<std::size_t>(vertex)]; };
  std::vector<int> ring{edges.begin()->first};
  int from = ring.front(), here = edges.begin()->second;
  edges.erase(edges.begin());
  while (here != ring.front()) {
    ring.push_back(here);
    auto [candidate, last] = edges.equal_range(here);
    if (candidate == last) break; // cannot happen in a patchwork of whole cells
    auto best = candidate;
    for (; candidate != last; ++candidate)
      if (left_turn(point(from), point(here), point(candidate->second)) >
          left_turn(point(from), point(here), point(best->second)))
        best = candidate;
    from = here;
    here = best->second;
    edges.erase(best);
  }
  return ring;
}

} // namespace

Patchwork full_section(const press::Snapshot& snapshot, const Colour& colour) {
  Builder builder;
  std::array<std::vector<int>, 4> images; // of each node in each quadrant
  for (std::size_t quadrant = 0; quadrant < 4; ++quadrant) {
    const bool mirror_r = quadrant & 1, mirror_z = quadrant & 2;
    for (std::size_t n = 0; n < snapshot.nodes.size(); ++n) {
      const auto [r, z] = snapshot.nodes[n];
      if (mirror_r && std::abs(r) < on_symmetry_line) images[quadrant].push_back(images[quadrant - 1][n]);
      else if (mirror_z && std::abs(z) < on_symmetry_line)
        images[quadrant].push_back(images[quadrant - 2][n]);
      else images[quadrant].push_back(builder.add({mirror_r ? -r : r, mirror_z ? -z : z}));
    }
  }
  for (std::size_t quadrant = 0; quadrant < 4; ++quadrant) {
    const bool flipped = quadrant == 1 || quadrant == 2; // one mirror turns the sense of rotation
    for (std::size_t element = 0; element < snapshot.elements.size(); ++element) {
      std::array<int, 4> corner{}, edge{}; // edge i joins corners i and i + 1
      for (std::size_t i = 0; i < 4; ++i)
        corner[i] = images[quadrant][static_cast<std::size_t>(snapshot.elements[element][i])];
      for (std::size_t i = 0; i < 4; ++i) edge[i] = builder.middle_of(corner[i], corner[(i + 1) % 4]);
      const int centre = builder.add(middle(builder.at(edge[0]), builder.at(edge[2])));
      for (std::size_t i = 0; i < 4; ++i) {
        std::array<int, 4> cell{corner[i], edge[i], centre, edge[(i + 3) % 4]};
        if (flipped) std::swap(cell[1], cell[3]);
        builder.patchwork.cells.push_back({cell, colour(element, i)});
      }
    }
  }
  return std::move(builder.patchwork);
}

std::vector<Region> regions(const Patchwork& patchwork) {
  std::vector<std::pair<std::uint64_t, int>> colour_left_of; // each edge once in each of its directions
  colour_left_of.reserve(4 * patchwork.cells.size());
  for (const auto& cell : patchwork.cells)
    for (std::size_t i = 0; i < 4; ++i)
      colour_left_of.emplace_back(edge_key(cell.corners[i], cell.corners[(i + 1) % 4]), cell.colour);
  std::sort(colour_left_of.begin(), colour_left_of.end());

  std::map<int, Edges> boundary; // ordered, so that equal input gives equal files
  for (const auto& cell : patchwork.cells)
    for (std::size_t i = 0; i < 4; ++i) {
      const int from = cell.corners[i], to = cell.corners[(i + 1) % 4];
      const std::pair same{edge_key(to, from), cell.colour};
      if (!std::binary_search(colour_left_of.begin(), colour_left_of.end(), same))
        boundary[cell.colour].emplace(from, to);
    }

  std::vector<Region> result;
  for (auto& [colour, edges] : boundary)
    while (!edges.empty()) {
      Region region{colour, 0, {}};
      for (const int vertex : take_ring(edges, patchwork.vertices))
        region.ring.push_back(patchwork.vertices[static_cast<std::size_t>(vertex)]);
      region.area = doubled_area(region.ring) / 2;
      if (region.area > 0) result.push_back(std::move(region)); // negative: the rim of a hole
    }
  std::stable_sort(result.begin(), result.end(),
                   [](const auto& a, const auto& b) { return a.area > b.area; });
  return result;
}

std::vector<Point> simplified(const std::vector<Point>& ring, double tolerance) {
  const std::size_t n = ring.size();
  if (n < 4) return ring;
  std::size_t start = 0; // of the stretch that one edge may replace
  const auto straight_to = [&](std::size_t end) {
    const Point &a = ring[start], &b = ring[end % n];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    for (std::size_t i = start + 1; i < end; ++i) {
      const double along = (b.x - a.x) * (ring[i].x - a.x) + (b.y - a.y) * (ring[i].y - a.y);
      const double across = (b.x - a.x) * (ring[i].y - a.y) - (b.y - a.y) * (ring[i].x - a.x);
      if (std::abs(across) > tolerance * length || along < 0 || along > length * length) return false;
    }
    return true;
  };
  std::vector<Point> result{ring.front()};
  for (std::size_t end = 2; end <= n; ++end)
    if (!straight_to(end)) {
      start = end - 1;
      result.push_back(ring[start]);
    }
  return result.size() < 3 ? ring : result;
}

} // namespace platen::plot
