#include "fe/contact_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace platen::fe {
namespace {

using Point = std::array<double, 2>;

Point between(Point a, Point b, double t) { return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])}; }

/// Distance s from the pole, fraction t of the way from the sphere to the axis along the circle around the
/// pole.
Point on_ring(double s, double t) {
  const double chord = std::asin(s / 2); // between the chord to the sphere and the tangent at the pole
  const double angle = chord + t * (std::numbers::pi / 2 - chord);
  return {s * std::cos(angle), 1 - s * std::sin(angle)};
}

/// Radii of the rings from the first to the last contact radius and on towards the equator.
std::vector<double> ring_radii(const ContactGrid& grid) {
  constexpr double outermost = 0.6, coarse = 1.0 / 6;
  const double fine = 1.0 / grid.columns;
  std::vector<double> s{grid.first_radius};
  double growth = fine;
  while (s.back() < outermost) {
    if (s.back() > grid.last_radius) growth = std::min(growth * 1.2, std::max(coarse, fine));
    s.push_back(s.back() * (1 + growth));
  }
  const double excess = s.back() / outermost; // taken from the coarse rings
  const double from = std::log(grid.last_radius), to = std::log(s.back());
  for (double& x : s)
    if (x > grid.last_radius) x *= std::pow(excess, -(std::log(x) - from) / (to - from));
  return s;
}

} // namespace

SectionMesh contact_disc(const ContactGrid& grid) {
  // The core: core x core elements around the pole, made round by the rows up to first_radius.
  const int core = (3 * grid.columns + 2) / 5, around = 2 * core;
  const double h = grid.first_radius / grid.columns, side = core * h;
  SectionMesh mesh;
  const auto add = [&](Point x) {
    mesh.nodes.push_back(x);
    return static_cast<int>(mesh.nodes.size()) - 1;
  };

  // Nodes of the core, row by row from the sphere downwards.
  const Point pole{0, 1}, at_sphere = on_ring(side, 0), at_axis = on_ring(side, 1);
  const Point corner = on_ring(1.2 * side, 0.5);
  std::vector<int> grid_of_core;
  for (int j = 0; j <= core; ++j)
    for (int i = 0; i <= core; ++i) {
      const double x = static_cast<double>(i) / core, y = static_cast<double>(j) / core;
      Point p = between(between(pole, at_sphere, x), between(at_axis, corner, x), y);
      const Point sphere = on_ring(std::max(i * h, 1e-300), 0), chord = between(pole, at_sphere, x);
      for (int k = 0; k < 2; ++k) p[k] += (1 - y) * (sphere[k] - chord[k]);
      if (i == 0) p[0] = 0;
      grid_of_core.push_back(add(p));
    }
  const auto core_node = [&](int i, int j) { return grid_of_core[j * (core + 1) + i]; };
  for (int j = 0; j < core; ++j)
    for (int i = 0; i < core; ++i)
      mesh.elements.push_back(
          {core_node(i, j + 1), core_node(i + 1, j + 1), core_node(i + 1, j), core_node(i, j)});

  // Lines of nodes around the core, each from the sphere to the axis.
  std::vector<int> line;
  for (int j = 0; j <= core; ++j) line.push_back(core_node(core, j));
  for (int i = core - 1; i >= 0; --i) line.push_back(core_node(i, core));
  std::vector<int> surface, axis;
  for (int i = 0; i <= core; ++i) surface.push_back(core_node(i, 0));
  for (int j = 0; j <= core; ++j) axis.push_back(core_node(0, j));
  const auto surround = [&](auto&& place) {
    std::vector<int> next;
    for (int k = 0; k <= around; ++k) {
      Point p = place(static_cast<double>(k) / around, k);
      if (k == around) p[0] = 0;
      next.push_back(add(p));
    }
    for (int k = 0; k < around; ++k) mesh.elements.push_back({line[k + 1], next[k + 1], next[k], line[k]});
    line = std::move(next);
    surface.push_back(line.front());
    axis.push_back(line.back());
  };

  const std::vector<int> core_edge = line;
  const int rounding = grid.columns - core;
  for (int row = 1; row <= rounding; ++row)
    surround([&](double t, int k) {
      const double share = static_cast<double>(row) / rounding;
      if (k == 0) return on_ring(side + row * h, 0);
      return between(mesh.nodes[core_edge[k]], on_ring(grid.first_radius, t), share);
    });
  const std::vector<double> s = ring_radii(grid);
  for (std::size_t row = 1; row < s.size(); ++row)
    surround([&](double t, int) { return on_ring(s[row], t); });

  // From the last ring to the equator: rows between the two, their outer ends on the sphere.
  constexpr int rows = 5;
  const std::vector<int> ring = line;
  const double from = 2 * std::asin(s.back() / 2);
  for (int row = 1; row <= rows; ++row) {
    const double share = static_cast<double>(row) / rows;
    const double polar = from + share * (std::numbers::pi / 2 - from);
    const Point outer{std::sin(polar), row == rows ? 0 : std::cos(polar)};
    surround([&](double t, int k) {
      const Point straight = between(mesh.nodes[ring[k]], {1 - t, 0}, share);
      const Point end = between(mesh.nodes[ring[0]], {1, 0}, share);
      return Point{straight[0] + (1 - t) * (outer[0] - end[0]), straight[1] + (1 - t) * (outer[1] - end[1])};
    });
  }
  for (const int node : line) mesh.nodes[node][1] = 0;
  mesh.mirrors = {{{1, 0}, std::move(axis)}, {{0, 1}, line}};
  for (std::size_t i = 0; i + 1 < surface.size(); ++i) mesh.surface.push_back({surface[i], surface[i + 1]});
  return mesh;
}

} // namespace platen::fe
