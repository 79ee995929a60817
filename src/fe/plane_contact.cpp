#include "fe/plane_contact.hpp"

#include "fe/stopwatch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace platen::fe {
namespace {

// Gauss-Legendre with 8 points on [-1, 1]: Abramowitz & Stegun, table 25.4.
constexpr std::array<double, 8> gauss_x{-0.960289856497536232, -0.796666477413626740, -0.525532409916328986,
                                        -0.183434642495649805, 0.183434642495649805,  0.525532409916328986,
                                        0.796666477413626740,  0.960289856497536232};
constexpr std::array<double, 8> gauss_w{0.101228536290376259, 0.222381034453374471, 0.313706645877887287,
                                        0.362683783378361983, 0.362683783378361983, 0.313706645877887287,
                                        0.222381034453374471, 0.101228536290376259};

std::vector<std::vector<int>> element_unknowns(const AxisymmetricSolid& solid) {
  std::vector<std::vector<int>> lists;
  for (int e = 0; e < static_cast<int>(solid.mesh.quads.size()); ++e) {
    const auto list = solid.unknowns_of(e);
    lists.emplace_back(list.begin(), list.end());
  }
  return lists;
}

/// The element that has both nodes, and their places in it.
EdgeElement element_at(const AxisymmetricMesh& mesh, int a, int b) {
  for (int e = 0; e < static_cast<int>(mesh.quads.size()); ++e) {
    const auto& quad = mesh.quads[e];
    const auto at_a = std::find(quad.begin(), quad.end(), a), at_b = std::find(quad.begin(), quad.end(), b);
    if (at_a != quad.end() && at_b != quad.end())
      return {e, {static_cast<int>(at_a - quad.begin()), static_cast<int>(at_b - quad.begin())}};
  }
  throw std::logic_error("a surface edge without element");
}

} // namespace

PlaneContact::PlaneContact(AxisymmetricSolid& solid_, NewtonSettings settings_, const ContactStiffness& rule)
    : u(solid_.unknowns(), 0.0), solid(solid_), settings(settings_),
      solver(solid_.unknowns(), element_unknowns(solid_), Symmetry::unsymmetric), fixed(solid_.unknowns(), 0),
      stiffness_rule(rule) {
  for (const int node : solid.mesh.axis) fixed[2 * node] = 1;
  for (const int node : solid.mesh.equator) fixed[2 * node + 1] = 1;
  for (int e = 0; e < static_cast<int>(solid.mesh.quads.size()); ++e) {
    const auto unknowns = solid.unknowns_of(e);
    for (int i = 0; i < 8; ++i)
      if (fixed[unknowns[i]]) fixed_in_elements.push_back({e, i});
  }
  // To begin with: Hertz's mean pressure at a contact radius of `pole`.
  const double E = material::initial_E(solid.model), nu = material::initial_nu(solid.model);
  pressure_scale = 4 / (3 * std::numbers::pi) * E / (1 - nu * nu) * stiffness_rule.pole;
  pressure_scale = std::min(pressure_scale, material::reference_stress(solid.model));

  const auto depth = [](double angle) { return 2 * std::pow(std::sin(angle / 2), 2); };
  const auto& surface = solid.mesh.surface;
  for (std::size_t s = 0; s + 1 < surface.size(); ++s) {
    const auto [r_a, z_a] = solid.mesh.nodes[surface[s]];
    const auto [r_b, z_b] = solid.mesh.nodes[surface[s + 1]];
    const double from = std::atan2(r_a, z_a), h = std::atan2(r_b, z_b) - from;
    auto& points = edges.emplace_back();
    for (int i = 0; i < points_per_edge; ++i) {
      const double t = (1 + gauss_x[i]) / 2, angle = from + t * h,
                   distance = std::max(angle, stiffness_rule.pole);
      points[i] = {{1 - t, t},
                   std::sin(angle) - (1 - t) * r_a - t * r_b,
                   stiffness_rule.uniform ? (1 - t) * depth(from) + t * depth(from + h) - h * h / 12
                                          : depth(angle),
                   2 * std::numbers::pi * std::sin(angle) * h * gauss_w[i] / 2,
                   stiffness_rule.relative_penetration * distance * distance,
                   stiffness_rule.elastic * E / distance};
    }
    edge_elements.push_back(element_at(solid.mesh, surface[s], surface[s + 1]));
  }
}

/// Force over penetration.
double PlaneContact::stiffness_of(const EdgePoint& point) const {
  if (stiffness_rule.uniform)
    return stiffness_rule.elastic * material::initial_E(solid.model) /
           std::max(largest_radius, stiffness_rule.pole) * point.area;
  return std::max(pressure_scale / point.flexibility, point.least_stiffness) * point.area;
}

/// Negative where the point penetrates.
double PlaneContact::height_above_plane(const EdgePoint& point, int edge,
                                        const std::vector<double>& x) const {
  double gap = point.depth - (1 - height);
  for (int k = 0; k < 2; ++k) gap -= point.N[k] * x[2 * solid.mesh.surface[edge + k] + 1];
  return gap;
}

/// Distance to the axis at the last equilibrium.
double PlaneContact::radius(const EdgePoint& point, int edge) const {
  double r = point.r;
  for (int k = 0; k < 2; ++k) {
    const int node = solid.mesh.surface[edge + k];
    r += point.N[k] * (solid.mesh.nodes[node][0] + u[2 * node]);
  }
  return r;
}

/// Forces of solid and contact.
Evaluation PlaneContact::evaluate(const std::vector<double>& x, Residual& residual) {
  const Evaluation evaluation = solid.evaluate(x);
  if (evaluation != Evaluation::done) return evaluation;
  const auto& surface = solid.mesh.surface;
  residual.touching.assign(edges.size() * points_per_edge, 0);
  for (std::size_t e = 0; e < edges.size(); ++e)
    for (int i = 0; i < points_per_edge; ++i) {
      const EdgePoint& point = edges[e][i];
      const double gap = height_above_plane(point, static_cast<int>(e), x);
      if (!(gap < 0)) continue;
      residual.touching[e * points_per_edge + i] = 1;
      const double stiffness = stiffness_of(point);
      for (int k = 0; k < 2; ++k) solid.force[2 * surface[e + k] + 1] -= stiffness * gap * point.N[k];
    }
  double free = 0, reaction = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    (fixed[i] ? reaction : free) += solid.force[i] * solid.force[i];
    if (fixed[i]) solid.force[i] = 0;
  }
  residual.force = solid.force;
  residual.relative = relative_residual(solid.model, settings, free, reaction);
  return std::isfinite(residual.relative) ? Evaluation::done : Evaluation::inverted_element;
}

/// Factorises the tangent of solid and contact. False where it is singular.
bool PlaneContact::linearise(const Residual& residual) {
  // Far from equilibrium perfectly plastic points at the contact edge give way to any force, and corrections
  // turn the small elements there inside out. The addition goes with the residual: the last corrections are
  // Newton's own.
  solid.linearise(std::min(0.1 * residual.relative, 0.3));
  for (std::size_t e = 0; e < edges.size(); ++e)
    for (int i = 0; i < points_per_edge; ++i) {
      if (!residual.touching[e * points_per_edge + i]) continue;
      const EdgePoint& point = edges[e][i];
      const auto& [element, corner] = edge_elements[e];
      for (int k = 0; k < 2; ++k)
        for (int l = 0; l < 2; ++l)
          solid.tangent[64 * element + 8 * (2 * corner[l] + 1) + 2 * corner[k] + 1] +=
              stiffness_of(point) * point.N[k] * point.N[l];
    }
  for (const auto& [element, i] : fixed_in_elements)
    for (int j = 0; j < 8; ++j)
      if (j != i) solid.tangent[64 * element + 8 * i + j] = solid.tangent[64 * element + 8 * j + i] = 0;
  Stopwatch watch(solid.times.factorisation_s);
  return solver.factorise(solid.tangent);
}

bool PlaneContact::solve_linear(std::span<double> x) {
  Stopwatch watch(solid.times.solve_s);
  solver.solve(x);
  return true;
}

StepReport PlaneContact::solve(double height_, std::vector<double> x) {
  if (const Contact c = contact(); c.radius > 0) {
    pressure_scale = std::max(pressure_scale, c.force / (std::numbers::pi * c.radius * c.radius));
    largest_radius = std::max(largest_radius, c.radius);
  }
  const double height_before = height;
  height = height_;
  StepReport report = newton(*this, settings, x);
  if (report.converged) u = std::move(x);
  else height = height_before;
  return report;
}

void PlaneContact::follow(double rise, std::vector<double>& guess) const {
  std::vector<char> moved(solid.mesh.nodes.size(), 0);
  for (int e = 0; e < static_cast<int>(edges.size()); ++e)
    for (const EdgePoint& point : edges[e])
      if (height_above_plane(point, e, u) < 0)
        for (int k = 0; k < 2; ++k)
          if (const int node = solid.mesh.surface[e + k]; !std::exchange(moved[node], 1))
            guess[2 * node + 1] += rise;
}

Contact PlaneContact::contact() const {
  const auto& surface = solid.mesh.surface;
  Contact c;
  double inner_pressure = 0, inner_middle = 0; // of the edge before
  for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
    double force = 0;
    const EdgePoint* outer = nullptr;
    for (const EdgePoint& point : edges[e])
      if (const double gap = height_above_plane(point, e, u); gap < 0) {
        const double stiffness = stiffness_of(point);
        force -= stiffness * gap;
        c.energy += stiffness * gap * gap / 2;
        outer = &point;
      }
    if (!outer) continue;
    c.force += force;
    const auto r = [&](int node) { return solid.mesh.nodes[node][0] + u[2 * node]; };
    const double r_a = r(surface[e]), r_b = r(surface[e + 1]);
    const double pressure = force / (std::numbers::pi * (r_b * r_b - r_a * r_a));
    // Under the outermost edges the pressure falls as sqrt(a^2 - r^2): extrapolate p^2 over r^2 from their
    // middles, but not beyond the middle of the first free edge.
    const double middle = (r_a * r_a + r_b * r_b) / 2,
                 fall = inner_pressure * inner_pressure - pressure * pressure;
    double square = fall > 0 ? middle + pressure * pressure * (middle - inner_middle) / fall : 1e300;
    square = std::clamp(square, std::pow(radius(*outer, e), 2), std::pow(1.5 * r_b - 0.5 * r_a, 2));
    c.radius = std::sqrt(square);
    inner_pressure = pressure;
    inner_middle = middle;
    c.peak_pressure = std::max(c.peak_pressure, pressure);
  }
  if (stiffness_rule.uniform) locate_edge(c);
  return c;
}

/// Towards the contact edge p falls as sqrt(a^2 - r^2), so the force outside r as (a^2 - r^2)^{3/2}: a
/// follows from the forces outside two radii. Single edges near the contact edge will not do: their pressure
/// depends on how it cuts them.
void PlaneContact::locate_edge(Contact& c) const {
  constexpr int outer = 4, inner = 9; // edges
  const auto rings = pressure_profile();
  const int touching = static_cast<int>(rings.size()) - 1;
  if (touching < inner) return;
  double force = 0, outer_force = 0;
  for (int i = touching - 1; i >= touching - inner; --i) {
    force += rings[i].pressure * (std::pow(rings[i].outer, 2) - std::pow(rings[i].inner, 2));
    if (i == touching - outer) outer_force = force;
  }
  const double ratio = std::pow(force / outer_force, 2.0 / 3);
  const double square =
      (ratio * std::pow(rings[touching - outer].inner, 2) - std::pow(rings[touching - inner].inner, 2)) /
      (ratio - 1);
  const double least = rings[touching - 2].inner, most = rings[touching].outer;
  c.radius = std::sqrt(std::clamp(square, least * least, most * most));
}

std::vector<PressureRing> PlaneContact::pressure_profile() const {
  const auto& surface = solid.mesh.surface;
  std::vector<PressureRing> rings;
  for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
    double force = 0;
    for (const EdgePoint& point : edges[e])
      if (const double gap = height_above_plane(point, e, u); gap < 0) force -= stiffness_of(point) * gap;
    const auto r = [&](int node) { return solid.mesh.nodes[node][0] + u[2 * node]; };
    const double inner = r(surface[e]), outer = r(surface[e + 1]);
    rings.push_back({inner, outer, force / (std::numbers::pi * (outer * outer - inner * inner))});
    if (!(force > 0)) break;
  }
  return rings;
}

} // namespace platen::fe
