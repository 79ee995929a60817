#include "press/yield_watch.hpp"

#include "material/reserve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace platen::press {
namespace {

constexpr double on_axis = 0.1; // r/a
/// The contact edge: r/a beyond the first, depth/a below the second.
constexpr double edge_radius = 0.8, edge_depth = 0.1;
/// The zone under the contact is what flows at least this deep, in contact radii.
constexpr double core_depth = 0.25;
constexpr std::array<double, 5> thresholds = {1e-5, 1e-4, 2e-4, 5e-4, 1e-3}; // of plastic strain
constexpr double degree = std::numbers::pi / 180;

struct Strength {
  using Pair = std::pair<double, double>;
  Pair operator()(const material::VonMises& m) const {
    return {0, std::holds_alternative<material::PerfectlyPlastic>(m.hardening) ? m.sigma_y : 0};
  }
  Pair operator()(const material::DruckerPrager& m) const {
    const double tan_beta = std::tan(m.beta_deg * degree);
    return {std::asin(3 * tan_beta / (6 + tan_beta)) / degree, m.sigma_c};
  }
  Pair operator()(const material::MohrCoulomb& m) const { return {m.phi_deg, m.reference_stress()}; }
  Pair operator()(const auto&) const { return {0, 0}; }
};

/// Norm of the plastic Hencky strain of a point: PEMAG of WG Fig. 3, sqrt(2/3 e:e), of the shape reached.
double plastic_magnitude(const fe::PointState& point) {
  const auto& [rr, zz, rz, tt] = point.Cp_inv;
  const double mean = (rr + zz) / 2, radius = std::hypot((rr - zz) / 2, rz);
  const double a = std::log(mean + radius) / 2, b = std::log(mean - radius) / 2, c = std::log(tt) / 2;
  return std::sqrt(2.0 / 3 * (a * a + b * b + c * c));
}

} // namespace

std::pair<double, double> drucker_prager_strength(const material::Model& model) {
  return std::visit(Strength{}, model);
}

YieldWatch::YieldWatch(const Case& c, const SphereRun& run) : press_case(c) {
  const fe::AxisymmetricMesh& mesh = run.sphere().mesh;
  const double inner = (1 - 1 / std::numbers::sqrt3) / 2, outer = 1 - inner;
  constexpr std::array<std::array<int, 2>, 4> corners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  std::map<std::pair<int, int>, int> edges;
  neighbours.resize(mesh.quads.size());
  for (int e = 0; e < static_cast<int>(mesh.quads.size()); ++e) {
    const auto& quad = mesh.quads[e];
    for (const auto& g : corners) {
      const double s = g[0] ? outer : inner, t = g[1] ? outer : inner;
      const std::array<double, 4> N{(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t};
      std::array<double, 2> x{0, 1};
      for (int a = 0; a < 4; ++a) {
        x[0] += N[a] * mesh.nodes[quad[a]][0];
        x[1] -= N[a] * mesh.nodes[quad[a]][1];
      }
      places.push_back(x);
    }
    for (int a = 0; a < 4; ++a) {
      const int n = quad[a], m = quad[(a + 1) % 4];
      const auto [at, is_new] = edges.try_emplace({std::min(n, m), std::max(n, m)}, e);
      if (is_new) continue;
      neighbours[e].push_back(at->second);
      neighbours[at->second].push_back(e);
    }
  }
  for (std::size_t i = 0; i + 1 < mesh.surface.size(); ++i) {
    const int n = mesh.surface[i], m = mesh.surface[i + 1];
    at_sphere.emplace_back(edges.at({std::min(n, m), std::max(n, m)}), mesh.nodes[n][0]);
  }
}

void YieldWatch::look(const SphereRun& run) {
  look_for_onset(run);
  look_for_break_through(run);
}

void YieldWatch::look_for_onset(const SphereRun& run) {
  const double a = run.row().contact_radius_m / press_case.radius_m;
  if ((axis.met && edge.met) || a < press_case.first_contact_bar) return;
  struct Nearest {
    int point = -1;
    double reserve = std::numeric_limits<double>::infinity();
  } at_axis, at_edge;
  for (int i = 0; i < static_cast<int>(places.size()); ++i) {
    const auto [r, depth] = places[i];
    const bool is_axis = r < on_axis * a && depth < 2 * a;
    const bool is_edge = r > edge_radius * a && r < 2 * a && depth < edge_depth * a;
    if (!(is_axis && !axis.met) && !(is_edge && !edge.met)) continue;
    const material::PointUpdate& point = run.sphere().updates[i];
    const bool elastic = point.zone == Zone::elastic;
    const double reserve = elastic ? material::stress_reserve(run.sphere().model, point.sigma, point.phi) : 1;
    Nearest& nearest = is_axis ? at_axis : at_edge;
    if (reserve < nearest.reserve) nearest = {i, reserve};
  }
  if (!axis.met) extend(axis, run, at_axis.point, at_axis.reserve);
  if (!edge.met) extend(edge, run, at_edge.point, at_edge.reserve);
}

void YieldWatch::extend(Candidate& candidate, const SphereRun& run, int point, double reserve) const {
  if (point < 0) return;
  if (reserve <= 1) {
    candidate.met = true;
    return;
  }
  const double a = run.row().contact_radius_m / press_case.radius_m;
  candidate.last =
      Onset{run.row().force_N * std::pow(reserve, 3), places[point][0] / a, places[point][1] / a};
}

void YieldWatch::look_for_break_through(const SphereRun& run) {
  if (broken.size() == thresholds.size() || run.row().zone_elastic == 1) return;
  const auto& points = run.state().points;
  std::vector<double> plastic(neighbours.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i) plastic[i / 4] += plastic_magnitude(points[i].state) / 4;
  for (const double threshold : thresholds) {
    const auto same = [&](const BreakThrough& b) { return b.plastic_strain == threshold; };
    if (std::none_of(broken.begin(), broken.end(), same) && breaks_through(run, plastic, threshold))
      broken.push_back({threshold, run.row().force_N});
  }
}

/// Whether the elements beyond the threshold join the axis under the contact with the sphere outside it.
bool YieldWatch::breaks_through(const SphereRun& run, const std::vector<double>& plastic,
                                double threshold) const {
  const double a = run.row().contact_radius_m / press_case.radius_m;
  std::vector<char> reached(plastic.size(), 0);
  std::vector<int> front;
  const auto reach = [&](int e) {
    if (reached[e] || plastic[e] < threshold) return;
    reached[e] = 1;
    front.push_back(e);
  };
  for (std::size_t i = 0; i < places.size(); ++i)
    if (places[i][0] < on_axis * a && places[i][1] > core_depth * a && places[i][1] < a)
      reach(static_cast<int>(i / 4));
  while (!front.empty()) {
    const int e = front.back();
    front.pop_back();
    for (const int n : neighbours[e]) reach(n);
  }
  return std::any_of(at_sphere.begin(), at_sphere.end(),
                     [&](const auto& at) { return reached[at.first] && at.second > a; });
}

void YieldWatch::report(LocalResult& result) const {
  if (axis.met) result.axis = axis.last;
  if (edge.met) result.edge = edge.last;
  if (axis.met && !axis.last)
    result.flags.push_back(
        "first yield comes before the smallest contact that the mesh resolves, so no onset is "
        "told: lower first_contact_bar");
  result.break_through = broken;
  std::sort(result.break_through.begin(), result.break_through.end(),
            [](const auto& x, const auto& y) { return x.plastic_strain < y.plastic_strain; });
}

} // namespace platen::press
