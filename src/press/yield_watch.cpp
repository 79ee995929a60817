#include "press/yield_watch.hpp"

#include "material/reserve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
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

/// Norm of the plastic Hencky strain of a point: PEMAG of WG Fig. 3, sqrt(2/3 e:e), of the shape reached.
double plastic_magnitude(const fe::Quad::State& point) {
  const auto [a, b, c] = fe::Quad::plastic_strain(point);
  return std::sqrt(2.0 / 3 * (a * a + b * b + c * c));
}

} // namespace

/// Where the Gauss points are, and which elements lie beside each other and at the sphere.
void YieldWatch::learn(const fe::Solid<fe::Quad>& solid) {
  const fe::SectionMesh& mesh = solid.mesh;
  for (int i = 0; i < solid.points(); ++i) {
    const auto [r, z] = solid.place(i);
    places.push_back({r, 1 - z});
  }
  std::map<std::pair<int, int>, int> edges;
  neighbours.resize(mesh.elements.size());
  for (int e = 0; e < solid.elements(); ++e)
    for (int a = 0; a < 4; ++a) {
      const int n = mesh.elements[e][a], m = mesh.elements[e][(a + 1) % 4];
      const auto [at, is_new] = edges.try_emplace({std::min(n, m), std::max(n, m)}, e);
      if (is_new) continue;
      neighbours[e].push_back(at->second);
      neighbours[at->second].push_back(e);
    }
  for (const auto& [n, m] : mesh.surface)
    at_sphere.emplace_back(edges.at({std::min(n, m), std::max(n, m)}), mesh.nodes[n][0]);
}

void YieldWatch::look(const Stepper& stepper, const State& state) {
  if (places.empty()) learn(stepper.solid());
  look_for_onset(stepper, state);
  look_for_break_through(stepper, state);
}

void YieldWatch::look_for_onset(const Stepper& stepper, const State& state) {
  const double a = state.row.contact_radius_m / stepper.radius_m;
  if (a < first_contact_bar) return;
  if (!axis.met) {
    double least = std::numeric_limits<double>::infinity();
    std::array<double, 2> place{};
    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto [r, depth] = places[i];
      if (r >= on_axis * a || depth >= 2 * a) continue;
      const material::PointUpdate& point = stepper.response().updates[i];
      const bool elastic = point.zone == Zone::elastic;
      const double reserve =
          elastic ? material::stress_reserve(stepper.solid().model, point.sigma, point.phi) : 1;
      if (reserve >= least) continue;
      least = reserve;
      place = {r / a, depth / a};
    }
    extend(axis, state.row.force_N, place, least);
  }
  if (!edge.met) extend(edge, state.row.force_N, {1, 0}, edge_reserve(stepper, state));
}

/// The factor by which the stress of the surface at the contact edge may grow. Under the surface it falls
/// with the square root of the depth, too steeply for any Gauss point; along the free surface it falls as
/// 1/r^2. So it is taken from the strains of the free surface, where one principal stress is zero, and
/// followed to the contact edge along a line through (r/a)^2/reserve.
double YieldWatch::edge_reserve(const Stepper& stepper, const State& state) const {
  const fe::SectionMesh& mesh = stepper.solid().mesh;
  const std::vector<double> u = stepper.displacement(state);
  const double E = material::initial_E(stepper.solid().model),
               nu = material::initial_nu(stepper.solid().model);
  const double a = state.row.contact_radius_m / stepper.radius_m;
  const auto place = [&](int node) {
    return std::array{mesh.nodes[node][0] + u[2 * node], mesh.nodes[node][1] + u[2 * node + 1]};
  };
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  int free = 0;
  for (const auto& [from, to] : mesh.surface) {
    const auto A = mesh.nodes[from], B = mesh.nodes[to], p = place(from), q = place(to);
    if (p[0] < a || ++free <= edges_left_out) continue;
    const double r = (p[0] + q[0]) / 2;
    if (r > beside * a && n > 1) break;
    const double along =
                     std::log(std::hypot(q[0] - p[0], q[1] - p[1]) / std::hypot(B[0] - A[0], B[1] - A[1])),
                 around = std::log((p[0] + q[0]) / (A[0] + B[0]));
    const double plane = E / (1 - nu * nu);
    const double reserve = material::stress_reserve(
        stepper.solid().model, {plane * (along + nu * around), plane * (around + nu * along), 0}, 0);
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

void YieldWatch::look_for_break_through(const Stepper& stepper, const State& state) {
  if (broken.size() == joining_strains.size() || state.row.zone_elastic == 1) return;
  const auto& points = state.points;
  std::vector<double> plastic(neighbours.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i) plastic[i / 4] += plastic_magnitude(points[i].state) / 4;
  const double now = joining_strain(plastic, state.row.contact_radius_m / stepper.radius_m);
  const double F = state.row.force_N;
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

void YieldWatch::report(Result& result) const {
  if (axis.met) result.axis = axis.last;
  if (edge.met) result.edge = edge.last;
  if ((axis.met && !axis.last) || (edge.met && !edge.last))
    result.flags.emplace_back(
        "first yield comes before the smallest contact that the mesh resolves, so no onset is "
        "told: lower first_contact_bar");
  result.break_through = broken;
}

} // namespace platen::press
