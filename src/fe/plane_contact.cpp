#include "fe/plane_contact.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace platen::fe {
namespace {

/// The residual may grow while zones and contacts settle, but not beyond this.
constexpr double diverged = 1e3;
/// Line search: the share of the work of the residual that a correction may leave, and how often it is
/// shortened.
constexpr double slope_left = 0.5;
constexpr int searches_max = 3;
/// Penetration at the highest mean pressure, over the square of the distance to the pole.
constexpr double relative_penetration = 0.001;
/// Least stiffness of the contact times the distance to the pole, over E. A flat punch of radius a on a
/// half-space springs back by (pi/2)(1 - nu^2) a p/E: the penetration by less than a hundredth of that, or
/// stiff material would seem to unload too softly.
constexpr double elastic_stiffness = 100;
/// Distance to the pole below which the contact gets no stiffer (R0), well inside the smallest contact of
/// interest.
constexpr double pole = 0.03;

// Gauss-Legendre with 8 points on [-1, 1]: Abramowitz & Stegun, table 25.4.
constexpr std::array<double, 8> gauss_x{-0.960289856497536232, -0.796666477413626740, -0.525532409916328986,
                                        -0.183434642495649805, 0.183434642495649805,  0.525532409916328986,
                                        0.796666477413626740,  0.960289856497536232};
constexpr std::array<double, 8> gauss_w{0.101228536290376259, 0.222381034453374471, 0.313706645877887287,
                                        0.362683783378361983, 0.362683783378361983, 0.313706645877887287,
                                        0.222381034453374471, 0.101228536290376259};

struct Stopwatch {
  double& into;
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  explicit Stopwatch(double& seconds) : into(seconds) {}
  ~Stopwatch() { into += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); }
};

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

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

PlaneContact::PlaneContact(AxisymmetricSolid& solid_, NewtonSettings settings_)
    : u(solid_.unknowns(), 0.0), solid(solid_), settings(settings_),
      solver(solid_.unknowns(), element_unknowns(solid_), Symmetry::unsymmetric),
      fixed(solid_.unknowns(), 0) {
  for (const int node : solid.mesh.axis) fixed[2 * node] = 1;
  for (const int node : solid.mesh.equator) fixed[2 * node + 1] = 1;
  for (int e = 0; e < static_cast<int>(solid.mesh.quads.size()); ++e) {
    const auto unknowns = solid.unknowns_of(e);
    for (int i = 0; i < 8; ++i)
      if (fixed[unknowns[i]]) fixed_in_elements.push_back({e, i});
  }
  // To begin with: Hertz's mean pressure at a contact radius of `pole`.
  const double E = material::initial_E(solid.model), nu = material::initial_nu(solid.model);
  pressure_scale = 4 / (3 * std::numbers::pi) * E / (1 - nu * nu) * pole;
  pressure_scale = std::min(pressure_scale, material::reference_stress(solid.model));

  const auto& surface = solid.mesh.surface;
  for (std::size_t s = 0; s + 1 < surface.size(); ++s) {
    const auto [r_a, z_a] = solid.mesh.nodes[surface[s]];
    const auto [r_b, z_b] = solid.mesh.nodes[surface[s + 1]];
    const double from = std::atan2(r_a, z_a), h = std::atan2(r_b, z_b) - from;
    auto& points = edges.emplace_back();
    for (int i = 0; i < points_per_edge; ++i) {
      const double t = (1 + gauss_x[i]) / 2, angle = from + t * h, distance = std::max(angle, pole);
      points[i] = {{1 - t, t},
                   std::sin(angle) - (1 - t) * r_a - t * r_b,
                   std::cos(angle) - (1 - t) * z_a - t * z_b,
                   2 * std::numbers::pi * std::sin(angle) * h * gauss_w[i] / 2,
                   relative_penetration * distance * distance,
                   elastic_stiffness * E / distance};
    }
    edge_elements.push_back(element_at(solid.mesh, surface[s], surface[s + 1]));
  }
}

/// Force over penetration.
double PlaneContact::stiffness_of(const EdgePoint& point) const {
  return std::max(pressure_scale / point.flexibility, point.least_stiffness) * point.area;
}

/// Negative where the point penetrates.
double PlaneContact::height_above_plane(const EdgePoint& point, int edge,
                                        const std::vector<double>& x) const {
  double z = point.z;
  for (int k = 0; k < 2; ++k) {
    const int node = solid.mesh.surface[edge + k];
    z += point.N[k] * (solid.mesh.nodes[node][1] + x[2 * node + 1]);
  }
  return height - z;
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
  residual.relative = std::sqrt(free / std::max(reaction, 1e-300));
  return std::isfinite(residual.relative) ? Evaluation::done : Evaluation::inverted_element;
}

/// Factorises the tangent of solid and contact. False where it is singular.
bool PlaneContact::linearise(const Residual& residual) {
  solid.linearise();
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

StepReport PlaneContact::solve(double height_, std::vector<double> x) {
  if (const Contact c = contact(); c.radius > 0)
    pressure_scale = std::max(pressure_scale, c.force / (std::numbers::pi * c.radius * c.radius));
  const double height_before = height;
  height = height_;
  StepReport report;
  const auto give_up = [&](const char* why) {
    report.why = why;
    height = height_before;
    return report;
  };
  std::vector<material::Zone> zones(solid.points());
  std::vector<char> touched;
  std::vector<double> correction(x.size());
  Residual residual;
  double slope_0 = 0; // work of the residual on the correction, before it
  for (;; ++report.iterations) {
    Evaluation evaluation = evaluate(x, residual);
    double fraction = 1;
    for (int search = 0; report.iterations > 0 && search < searches_max; ++search) {
      const bool failed = evaluation != Evaluation::done;
      const double slope = failed ? 0 : -dot(correction, solid.force);
      if (!failed && (std::abs(slope) <= slope_left * std::abs(slope_0) || slope > 0)) break;
      const double next = fraction * (failed ? 0.5 : std::clamp(slope_0 / (slope_0 - slope), 0.2, 0.8));
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += (next - fraction) * correction[i];
      fraction = next;
      evaluation = evaluate(x, residual);
    }
    if (evaluation == Evaluation::inverted_element) return give_up("an element turned inside out");
    if (evaluation == Evaluation::refused_material) return give_up("the material found no admissible state");

    for (int i = 0; i < solid.points(); ++i) {
      report.zone_changed |= report.iterations > 0 && zones[i] != solid.updates[i].zone;
      zones[i] = solid.updates[i].zone;
    }
    report.contact_changed |= report.iterations > 0 && residual.touching != touched;
    touched = residual.touching;
    report.residuals.push_back(residual.relative);
    if (residual.relative <= settings.relative_residual_tolerance) break;
    if (residual.relative > diverged && report.iterations > 3) return give_up("the iteration diverged");
    if (report.iterations == settings.iterations_max) return give_up("the iteration did not converge");

    if (!linearise(residual)) return give_up("the tangent is singular");
    for (std::size_t i = 0; i < correction.size(); ++i) correction[i] = -solid.force[i];
    {
      Stopwatch watch(solid.times.solve_s);
      solver.solve(correction);
    }
    slope_0 = -dot(correction, solid.force);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += correction[i];
  }
  report.converged = true;
  u = std::move(x);
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
  return c;
}

} // namespace platen::fe
