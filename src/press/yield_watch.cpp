#include "press/yield_watch.hpp"

#include "material/reserve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <queue>

namespace platen::press {
namespace {

constexpr double on_axis = 0.1; // r/a
/// Where the free surface beside the contact is looked at: edges of the mesh left out beside the contact
/// edge, which cuts them, and r/a up to here.
constexpr int edges_left_out = 2;
constexpr double beside = 1.4;
/// The zone under the contact is what flows at least this deep, in contact radii.
constexpr double core_depth = 0.25;
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
  if (a < press_case.first_contact_bar) return;
  if (!axis.met) {
    double least = std::numeric_limits<double>::infinity();
    std::array<double, 2> place{};
    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto [r, depth] = places[i];
      if (r >= on_axis * a || depth >= 2 * a) continue;
      const material::PointUpdate& point = run.sphere().updates[i];
      const bool elastic = point.zone == Zone::elastic;
      const double reserve =
          elastic ? material::stress_reserve(run.sphere().model, point.sigma, point.phi) : 1;
      if (reserve >= least) continue;
      least = reserve;
      place = {r / a, depth / a};
    }
    extend(axis, run.row().force_N, place, least);
  }
  if (!edge.met) extend(edge, run.row().force_N, {1, 0}, edge_reserve(run));
}

/// The factor by which the stress of the surface at the contact edge may grow. Under the surface it falls
/// with the square root of the depth, too steeply for any Gauss point; along the free surface it falls as
/// 1/r^2. So it is taken from the strains of the free surface, where one principal stress is zero, and
/// followed to the contact edge along a line through (r/a)^2/reserve.
double YieldWatch::edge_reserve(const SphereRun& run) const {
  const fe::AxisymmetricMesh& mesh = run.sphere().mesh;
  const std::vector<double>& u = run.state().u;
  const double E = material::initial_E(run.sphere().model), nu = material::initial_nu(run.sphere().model);
  const double a = run.row().contact_radius_m / press_case.radius_m;
  const auto place = [&](int node) {
    return std::array{mesh.nodes[node][0] + u[2 * node], mesh.nodes[node][1] + u[2 * node + 1]};
  };
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  int free = 0;
  for (std::size_t i = 0; i + 1 < mesh.surface.size(); ++i) {
    const int from = mesh.surface[i], to = mesh.surface[i + 1];
    const auto A = mesh.nodes[from], B = mesh.nodes[to], p = place(from), q = place(to);
    if (p[0] < a || ++free <= edges_left_out) continue;
    const double r = (p[0] + q[0]) / 2;
    if (r > beside * a && n > 1) break;
    const double along =
                     std::log(std::hypot(q[0] - p[0], q[1] - p[1]) / std::hypot(B[0] - A[0], B[1] - A[1])),
                 around = std::log((p[0] + q[0]) / (A[0] + B[0]));
    const double plane = E / (1 - nu * nu);
    const double reserve = material::stress_reserve(
        run.sphere().model, {plane * (along + nu * around), plane * (around + nu * along), 0}, 0);
    const double t = r / a - 1, value = (1 + t) * (1 + t) / reserve;
    n += 1, x += t, y += value, xx += t * t, xy += t * value;
  }
  if (n < 2) return std::numeric_limits<double>::infinity();
  return (n * xx - x * x) / (y * xx - x * xy);
}

void YieldWatch::extend(Candidate& candidate, double force_N, std::array<double, 2> place, double reserve) {
  if (reserve <= 1) candidate.met = true;
  else if (reserve < 1e6) candidate.last = Onset{force_N * std::pow(reserve, 3), place[0], place[1]};
}

void YieldWatch::look_for_break_through(const SphereRun& run) {
  if (broken.size() == joining_strains.size() || run.row().zone_elastic == 1) return;
  const auto& points = run.state().points;
  std::vector<double> plastic(neighbours.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i) plastic[i / 4] += plastic_magnitude(points[i].state) / 4;
  const double now = joining_strain(plastic, run.row().contact_radius_m / press_case.radius_m);
  const double F = run.row().force_N;
  for (const double threshold : joining_strains)
    if (joined.plastic_strain < threshold && now >= threshold)
      broken.push_back(
          {threshold, joined.force_N + (F - joined.force_N) * (threshold - joined.plastic_strain) /
                                           (now - joined.plastic_strain)});
  joined = {std::max(joined.plastic_strain, now), F};
}

/// The largest plastic strain beyond which elements still join the axis under the contact with the sphere
/// outside it: of all ways between the two the one whose weakest element is strongest. It grows with the
/// load, and between two steps it is interpolated.
double YieldWatch::joining_strain(const std::vector<double>& plastic, double a) const {
  std::vector<double> weakest(plastic.size(), 0); // on the best way to the element
  std::priority_queue<std::pair<double, int>> front;
  const auto reach = [&](int e, double strain) {
    if (strain <= weakest[e]) return;
    weakest[e] = strain;
    front.emplace(strain, e);
  };
  for (std::size_t i = 0; i < places.size(); ++i)
    if (places[i][0] < on_axis * a && places[i][1] > core_depth * a && places[i][1] < a)
      reach(static_cast<int>(i / 4), plastic[i / 4]);
  while (!front.empty()) {
    const auto [strain, e] = front.top();
    front.pop();
    if (strain < weakest[e]) continue;
    for (const int n : neighbours[e]) reach(n, std::min(strain, plastic[n]));
  }
  double most = 0;
  for (const auto& [e, angle] : at_sphere)
    if (angle > a) most = std::max(most, weakest[e]);
  return most;
}

void YieldWatch::report(LocalResult& result) const {
  if (axis.met) result.axis = axis.last;
  if (edge.met) result.edge = edge.last;
  if ((axis.met && !axis.last) || (edge.met && !edge.last))
    result.flags.push_back(
        "first yield comes before the smallest contact that the mesh resolves, so no onset is "
        "told: lower first_contact_bar");
  result.break_through = broken;
}

} // namespace platen::press
