#include "study/grid.hpp"

#include "press/case.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace platen::study {
namespace {

using press::CurvePoint;

constexpr int parts = 20; // of an unloading branch

/// Weighted harmonic mean of the two slopes beside a point; zero where they differ in sign.
double slope(double h_before, double h_after, double s_before, double s_after) {
  if (!(s_before * s_after > 0)) return 0;
  const double w1 = 2 * h_after + h_before, w2 = h_after + 2 * h_before;
  return (w1 + w2) / (w1 / s_before + w2 / s_after);
}

/// The quantity of the points of one branch.
template <class Of> std::vector<double> column(const std::vector<CurvePoint>& points, Of of) {
  std::vector<double> values;
  for (const auto& point : points) values.push_back(of(point));
  return values;
}

/// Whether the overlap goes one way; 0 where it turns.
int direction(const std::vector<double>& x) {
  const auto goes = [&](auto compare) { return std::adjacent_find(x.begin(), x.end(), compare) == x.end(); };
  if (goes([](double a, double b) { return !(a < b); })) return 1;
  if (goes([](double a, double b) { return !(a > b); })) return -1;
  return 0;
}

/// The overlaps of the grid within a branch.
std::vector<double> overlaps(const std::vector<double>& delta_bar, const std::vector<double>& force,
                             press::Branch branch, double step) {
  std::vector<double> grid;
  if (branch == press::Branch::loading) {
    const auto add = [&](double x) {
      if (x >= delta_bar.front() && x <= delta_bar.back() * (1 + 1e-9))
        grid.push_back(std::min(x, delta_bar.back()));
    };
    for (const double part : {0.125, 0.25, 0.5}) add(part * step);
    for (int i = 1; i * step <= delta_bar.back() * (1 + 1e-9); ++i) add(i * step);
    return grid;
  }
  std::size_t first = 0, last = force.size() - 1; // the loaded stretch, with the first zero beside it
  while (first + 1 < last && !(force[first + 1] > 0)) ++first;
  while (last > first + 1 && !(force[last - 1] > 0)) --last;
  for (int i = 0; i <= parts; ++i)
    grid.push_back(i == 0       ? delta_bar[first]
                   : i == parts ? delta_bar[last]
                                : delta_bar[first] + (delta_bar[last] - delta_bar[first]) * i / parts);
  return grid;
}

void add_branch(std::vector<GridPoint>& rows, const press::Curve& curve,
                const std::vector<CurvePoint>& points, double step) {
  const double R = curve.radius_m, unit = std::numbers::pi * R * R * curve.sigma_ref_Pa;
  const auto delta_bar = column(points, [](const CurvePoint& p) { return p.delta_bar; });
  const auto force = column(points, [](const CurvePoint& p) { return p.force_N; });
  const bool x_walls = curve.experiment == press::Die::name || curve.experiment == press::Triaxial::name;
  const bool y_walls = curve.experiment == press::Triaxial::name;
  const bool turns = points.size() < 2 || direction(delta_bar) == 0;
  const auto grid = turns ? delta_bar : overlaps(delta_bar, force, points.front().branch, step);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const auto at = [&](auto of) {
      const auto values = column(points, of);
      return turns ? values[i] : interpolate(delta_bar, values, grid[i]);
    };
    const auto contact = [&](int plane) { // along z, x, y
      return Contact{at([&](const CurvePoint& p) { return p.plane(plane).force_N; }) / unit,
                     at([&](const CurvePoint& p) { return p.plane(plane).contact_radius_m; }) / R};
    };
    GridPoint row{points.front().branch_id, points.front().branch, grid[i], contact(0), {}, {}};
    if (x_walls) row.x = contact(1);
    if (y_walls) row.y = contact(2);
    rows.push_back(row);
  }
}

} // namespace

double interpolate(std::span<const double> x, std::span<const double> y, double at) {
  const bool up = x.front() < x.back();
  const auto after = std::lower_bound(x.begin() + 1, x.end() - 1, at,
                                      [&](double a, double b) { return up ? a < b : a > b; });
  const std::size_t j = after - x.begin(), i = j - 1;
  const auto h = [&](std::size_t k) { return x[k + 1] - x[k]; };
  const auto s = [&](std::size_t k) { return (y[k + 1] - y[k]) / h(k); };
  const double d0 = i == 0 ? s(i) : slope(h(i - 1), h(i), s(i - 1), s(i));
  const double d1 = j + 1 == x.size() ? s(i) : slope(h(i), h(j), s(i), s(j));
  const double t = (at - x[i]) / h(i);
  return y[i] * (1 + 2 * t) * (1 - t) * (1 - t) + h(i) * d0 * t * (1 - t) * (1 - t) +
         y[j] * t * t * (3 - 2 * t) - h(i) * d1 * t * t * (1 - t);
}

std::vector<GridPoint> on_grid(const press::Curve& curve, double step) {
  std::vector<GridPoint> rows;
  std::vector<int> ids;
  for (const auto& point : curve.points)
    if (std::find(ids.begin(), ids.end(), point.branch_id) == ids.end()) ids.push_back(point.branch_id);
  std::sort(ids.begin(), ids.end());
  for (const int id : ids) {
    std::vector<CurvePoint> points;
    for (const auto& point : curve.points)
      if (point.branch_id == id) points.push_back(point);
    add_branch(rows, curve, points, step);
  }
  return rows;
}

double difference(const press::Curve& a, const press::Curve& b) {
  constexpr double other = std::numeric_limits<double>::infinity();
  const auto* end = press::loading_end(a);
  if (!end || !press::loading_end(b)) return a.points.empty() && b.points.empty() ? 0 : other;
  const double step = end->delta_bar / 20.5; // the last row is not at the end, where either may have it
  const auto left = on_grid(a, step), right = on_grid(b, step);
  const auto same_branch = [](const GridPoint& l, const GridPoint& r) {
    return l.branch_id == r.branch_id && l.branch == r.branch;
  };
  if (!std::ranges::equal(left, right, same_branch)) return other;
  double largest = 0;
  const auto compare = [&](auto of) {
    double scale = 0, apart = 0;
    for (std::size_t i = 0; i < left.size(); ++i) {
      scale = std::max(scale, std::abs(of(left[i])));
      apart = std::max(apart, std::abs(of(left[i]) - of(right[i])));
    }
    if (apart > 0) largest = std::max(largest, apart / scale);
  };
  compare([](const GridPoint& row) { return row.delta_bar; });
  for (const auto wall : {&GridPoint::x, &GridPoint::y}) {
    compare([&](const GridPoint& row) { return (row.*wall).value_or(Contact{}).F_bar; });
    compare([&](const GridPoint& row) { return (row.*wall).value_or(Contact{}).a_bar; });
  }
  compare([](const GridPoint& row) { return row.z.F_bar; });
  compare([](const GridPoint& row) { return row.z.a_bar; });
  return largest;
}

} // namespace platen::study
