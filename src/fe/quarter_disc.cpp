#include "fe/quarter_disc.hpp"

#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <numbers>

namespace platen::fe {
namespace {

using Point = std::array<double, 2>;
using Line = std::function<Point(double)>; ///< along an edge, parameter in [0, 1]

/// Fractions 0..1 of n intervals whose sizes grow geometrically, the last `ratio` times the first.
std::vector<double> graded(int n, double ratio) {
  std::vector<double> x(n + 1);
  double size = 1, sum = 0;
  for (int i = 0; i <= n; ++i) {
    x[i] = sum;
    sum += size;
    size *= std::pow(ratio, 1.0 / std::max(n - 1, 1));
  }
  for (double& v : x) v /= x[n];
  return x;
}

/// Collects blocks; nodes at the same place are one node.
class Builder {
 public:
  /// Coons patch between bottom, top (both along i) and left, right (both along j), with the spacing of each
  /// edge blended linearly.
  void block(const Line& bottom, const Line& top, const Line& left, const Line& right,
             const std::vector<double>& s_bottom, const std::vector<double>& s_top,
             const std::vector<double>& t_left, const std::vector<double>& t_right) {
    const int n = static_cast<int>(s_bottom.size()) - 1, m = static_cast<int>(t_left.size()) - 1;
    std::vector<int> id((n + 1) * (m + 1));
    for (int j = 0; j <= m; ++j)
      for (int i = 0; i <= n; ++i) {
        // Where the straight lines that join equal indices of opposite edges cross.
        const double a = s_bottom[i], da = s_top[i] - a, b = t_left[j], db = t_right[j] - b;
        const double t = (b + a * db) / (1 - da * db), s = a + da * t;
        const Point B = bottom(s), T = top(s), L = left(t), R = right(t);
        const Point c00 = bottom(0), c10 = bottom(1), c01 = top(0), c11 = top(1);
        Point x;
        for (int k = 0; k < 2; ++k)
          x[k] = (1 - t) * B[k] + t * T[k] + (1 - s) * L[k] + s * R[k] -
                 ((1 - s) * (1 - t) * c00[k] + s * (1 - t) * c10[k] + (1 - s) * t * c01[k] + s * t * c11[k]);
        id[j * (n + 1) + i] = node(x);
      }
    for (int j = 0; j < m; ++j)
      for (int i = 0; i < n; ++i)
        mesh.elements.push_back({id[j * (n + 1) + i], id[j * (n + 1) + i + 1], id[(j + 1) * (n + 1) + i + 1],
                                 id[(j + 1) * (n + 1) + i]});
  }

  int node(Point x) {
    for (double& v : x)
      if (std::abs(v) < 1e-13) v = 0;
    const std::array<long, 2> key{std::lround(x[0] * 1e9), std::lround(x[1] * 1e9)};
    const auto [at, is_new] = ids.try_emplace(key, static_cast<int>(mesh.nodes.size()));
    if (is_new) mesh.nodes.push_back(x);
    return at->second;
  }

  SectionMesh mesh;

 private:
  std::map<std::array<long, 2>, int> ids;
};

Line straight(Point a, Point b) {
  return [=](double s) { return Point{a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])}; };
}
Line arc(double from, double to) { // angles from the axis
  return [=](double s) {
    const double angle = from + s * (to - from);
    return Point{std::sin(angle), std::cos(angle)};
  };
}
/// Replaces each element at the sphere by a transition (one column below, three above) and rows of three
/// columns: the contact edge moves along the surface element by element, and its steps should be small.
void refine_surface(Builder& b, int fine_rows) {
  // Fractions of the element's depth from its inner side: the transition row, then equal fine rows.
  constexpr double transition = 0.24;
  std::vector<double> row{0};
  for (const double t : graded(fine_rows, 1)) row.push_back(transition + (1 - transition) * t);
  const auto quads = std::move(b.mesh.elements);
  b.mesh.elements.clear();
  const auto on_sphere = [&](int i) {
    return std::abs(std::hypot(b.mesh.nodes[i][0], b.mesh.nodes[i][1]) - 1) < 1e-12;
  };
  for (auto quad : quads) {
    // Turn the element so that its third and fourth corners are the ones on the sphere.
    int turns = 0;
    for (; turns < 4 && !(on_sphere(quad[2]) && on_sphere(quad[3])); ++turns)
      quad = {quad[1], quad[2], quad[3], quad[0]};
    if (turns == 4) {
      b.mesh.elements.push_back(quad);
      continue;
    }
    const Point A = b.mesh.nodes[quad[0]], B = b.mesh.nodes[quad[1]], C = b.mesh.nodes[quad[2]],
                D = b.mesh.nodes[quad[3]];
    const double from = std::atan2(D[0], D[1]), to = std::atan2(C[0], C[1]);
    const auto at = [&](double s, double t) {
      // Bilinear, plus the bulge of the sphere over its chord, fading inwards.
      Point x;
      const Point on_arc = arc(from, to)(s);
      for (int k = 0; k < 2; ++k) x[k] = (1 - t) * ((1 - s) * A[k] + s * B[k]) + t * on_arc[k];
      return b.node(x);
    };
    const double t = row[1];
    const int I_1 = at(1.0 / 3, t * 0.5), I_2 = at(2.0 / 3, t * 0.5);
    const std::array<int, 4> T{at(0, t), at(1.0 / 3, t), at(2.0 / 3, t), at(1, t)};
    b.mesh.elements.push_back({quad[0], quad[1], I_2, I_1});
    b.mesh.elements.push_back({I_1, I_2, T[2], T[1]});
    b.mesh.elements.push_back({quad[0], I_1, T[1], T[0]});
    b.mesh.elements.push_back({I_2, quad[1], T[3], T[2]});
    for (std::size_t j = 1; j + 1 < row.size(); ++j)
      for (int i = 0; i < 3; ++i)
        b.mesh.elements.push_back({at(i / 3.0, row[j]), at((i + 1) / 3.0, row[j]),
                                   at((i + 1) / 3.0, row[j + 1]), at(i / 3.0, row[j + 1])});
  }
}

/// Counts along the three kinds of edges, and the fine rows below the sphere.
struct Counts {
  int pole;   ///< along the sphere in the pole block
  int depth;  ///< below the sphere
  int centre; ///< from the centre to the pole block, and along the sphere in the equator block
  int fine;   ///< rows below the sphere that have three columns for one
  bool twice; ///< the outermost row has nine
  int elements() const {
    const int on_sphere = pole + centre;
    return pole * depth + pole * centre + depth * centre + added(fine) * on_sphere +
           (twice ? added(1) * 3 * on_sphere : 0);
  }

 private:
  static constexpr int added(int rows) { return 3 + 3 * rows; } ///< by a refinement, an edge on the sphere
};

Counts counts_for(int elements) {
  // On coarser meshes the small elements would lie on large ones, and be folded by them.
  constexpr int least_twice = 1000;
  const auto scaled = [elements](double scale) {
    const auto count = [&](double n, int least) {
      return std::max(least, static_cast<int>(std::lround(n * scale)));
    };
    return Counts{count(5, 4), count(6.5, 6), count(2, 2), count(1, 1), elements >= least_twice};
  };
  double scale = 0.5;
  while (scaled(scale * 1.01).elements() <= elements) scale *= 1.01;
  // The next one up, if that is nearer.
  const Counts below = scaled(scale), above = scaled(scale * 1.01);
  return elements - below.elements() <= above.elements() - elements ? below : above;
}

/// Rows of a block below the sphere: the outermost one takes `share` of the depth, to be refined.
std::vector<double> with_surface_row(int n, double ratio, double share) {
  std::vector<double> x = graded(n - 1, ratio);
  for (double& v : x) v *= 1 - share;
  x.push_back(1);
  return x;
}

} // namespace

SectionMesh quarter_disc(int elements) {
  const auto [n, d, m, fine, twice] = counts_for(elements);
  // Split points: on the axis, on the equator, on the sphere, inside. The block at the pole is the large one,
  // since the contact grows over it.
  constexpr double angle = 1.15;
  const Point O{0, 0}, on_axis{0, 0.30}, on_equator{0.52, 0}, inside{0.50, 0.22};
  const Point P{0, 1}, E{1, 0}, on_sphere{std::sin(angle), std::cos(angle)};
  // Far size over size at the pole, along the sphere; the share of the depth that the surface row takes.
  constexpr double along = 24;
  const auto pole_along = graded(n, along), inner_along = graded(n, 1.3);
  const auto pole_depth = with_surface_row(d, 0.5, 0.11), far_depth = with_surface_row(d, 0.6, 0.13);
  const auto even_m = graded(m, 1);

  Builder b;
  // Pole: i from the axis outwards, j upwards.
  b.block(straight(on_axis, inside), arc(0, angle), straight(on_axis, P), straight(inside, on_sphere),
          inner_along, pole_along, pole_depth, far_depth);
  // Centre: i along the equator, j up the axis.
  b.block(straight(O, on_equator), straight(on_axis, inside), straight(O, on_axis),
          straight(on_equator, inside), inner_along, inner_along, even_m, even_m);
  // Equator: i outwards, j upwards.
  b.block(straight(on_equator, E), straight(inside, on_sphere), straight(on_equator, inside),
          arc(std::numbers::pi / 2, angle), far_depth, far_depth, even_m, even_m);
  refine_surface(b, fine);
  if (twice) refine_surface(b, 1);

  SectionMesh& mesh = b.mesh;
  mesh.mirrors = {{{1, 0}, {}}, {{0, 1}, {}}};
  std::map<double, int> on_surface;
  for (int i = 0; i < static_cast<int>(mesh.nodes.size()); ++i) {
    const auto [r, z] = mesh.nodes[i];
    if (r == 0) mesh.mirrors[0].nodes.push_back(i);
    if (z == 0) mesh.mirrors[1].nodes.push_back(i);
    if (std::abs(std::hypot(r, z) - 1) < 1e-12) on_surface[std::atan2(r, z)] = i;
  }
  for (auto at = on_surface.begin(); std::next(at) != on_surface.end(); ++at)
    mesh.surface.push_back({at->second, std::next(at)->second});
  return mesh;
}

} // namespace platen::fe
