#include "press/sphere_run.hpp"

#include "core/version.hpp"
#include "fe/contact_grid.hpp"
#include "press/point_account.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace platen::press {
namespace {

bool is_local(const Case& c) { return c.experiment == "local"; }

fe::AxisymmetricMesh mesh_for(const Case& c) {
  if (!is_local(c)) return fe::quarter_disc(c.elements);
  return fe::contact_disc({.first_radius = c.first_contact_bar, .columns = c.edges});
}

fe::NewtonSettings newton_for(const Case& c) {
  fe::NewtonSettings settings;
  if (is_local(c)) settings.relative_residual_tolerance = 1e-6;
  return settings;
}

/// Local curves are compared with Hertz to parts of a per cent.
fe::ContactStiffness stiffness_for(const Case& c) {
  if (!is_local(c)) return {};
  return {.elastic = 1000, .pole = c.first_contact_bar, .uniform = true};
}

} // namespace

SphereRun::SphereRun(const Case& c) : SphereRun(c, newton_for(c)) {}

SphereRun::SphereRun(const Case& c, const fe::NewtonSettings& newton)
    : radius_m(c.radius_m), sigma_ref(material::reference_stress(c.material.model)),
      solid(mesh_for(c), c.material.model), contact(solid, newton, stiffness_for(c)) {
  now.u.assign(solid.unknowns(), 0.0);
  now.change = now.u;
  now.points.resize(solid.points());
  now.row.rho_r_mean = now.row.rho_r_min = now.row.rho_r_max = material::relative_density(solid.model, 0);
}

void SphereRun::restore(const State& s) {
  now = s;
  contact.u = s.u;
}

fe::StepReport SphereRun::advance(double delta_bar) {
  const double step = delta_bar - now.delta_bar;
  // Newton starts from the continued motion: at the converged state itself every plastic point sits on the
  // kink of its yield surface.
  const double ratio = now.step != 0 ? step / now.step : 0;
  std::vector<double> guess = now.u;
  if (ratio > 0)
    for (std::size_t i = 0; i < guess.size(); ++i) guess[i] += ratio * now.change[i];
  else contact.follow(-step, guess);
  std::vector<Flow> points;
  for (std::size_t i = 0; i < now.points.size(); ++i) {
    points.push_back(next_return(now.points[i], now.delta_bar, delta_bar));
    solid.committed[i] = points[i].start;
  }
  fe::StepReport report = contact.solve(1 - delta_bar, std::move(guess));
  count(report, counted);
  if (!report.converged) return report;
  for (std::size_t i = 0; i < now.u.size(); ++i) now.change[i] = contact.u[i] - now.u[i];
  now.step = step;
  now.u = contact.u;
  account(delta_bar, report.iterations, points);
  now.points = std::move(points);
  return report;
}

/// What a sphere of finite size is shorter by than two half-spaces (Tatara 1991), at one of its two contacts:
/// F f/(pi E), f = 2(1+nu) R^2/(a^2+4R^2)^{3/2} + (1-nu^2)/(a^2+4R^2)^{1/2}.
double SphereRun::far_field(const CurvePoint& row) const {
  const double E = material::initial_E(solid.model), nu = material::initial_nu(solid.model);
  const double l = std::hypot(row.contact_radius_m, 2 * radius_m);
  const double f = 2 * (1 + nu) * radius_m * radius_m / (l * l * l) + (1 - nu * nu) / l;
  return row.force_N * f / (std::numbers::pi * E);
}

/// The row of the curve at the new equilibrium.
void SphereRun::account(double delta_bar, int iterations, std::vector<Flow>& points) {
  const double R = radius_m, R2 = R * R, R3 = R2 * R;
  const fe::Contact c = contact.contact();
  const CurvePoint before = now.row;
  CurvePoint row = before;
  row.delta_bar = delta_bar;
  row.delta_m = delta_bar * R;
  row.force_N = c.force * R2;
  row.F_bar = c.force / (std::numbers::pi * sigma_ref);
  row.contact_radius_m = c.radius * R;
  row.mean_pressure_Pa = c.radius > 0 ? c.force / (std::numbers::pi * c.radius * c.radius) : 0;
  row.peak_pressure_Pa = c.peak_pressure;
  row.hertz_delta_m = row.delta_m + far_field(row);
  row.iterations = iterations;
  row.equator_displacement_m = contact.u[2 * solid.mesh.surface.back()] * R;
  row.work_J = before.work_J + (before.force_N + row.force_N) / 2 * (row.delta_m - before.delta_m);

  const Totals totals = account_points(solid, points, now.points, row);
  row.stored_J = (totals.stored + c.energy) * R3;
  row.dissipated_J = before.dissipated_J + totals.dissipated * R3;
  now.row = row;
  now.delta_bar = delta_bar;
}

Statistics SphereRun::statistics() const {
  return statistics_of(counted, solid, solid.mesh.quads.size(), solid.unknowns());
}

Snapshot SphereRun::snapshot(Branch branch) const {
  Snapshot s;
  s.delta_bar = now.delta_bar;
  s.branch = branch;
  for (std::size_t i = 0; i < solid.mesh.nodes.size(); ++i) {
    s.displacement.push_back({now.u[2 * i], now.u[2 * i + 1]});
    s.nodes.push_back({solid.mesh.nodes[i][0] + now.u[2 * i], solid.mesh.nodes[i][1] + now.u[2 * i + 1]});
  }
  s.quads = solid.mesh.quads;
  for (std::size_t e = 0; e < s.quads.size(); ++e) {
    std::array<Zone, 4> zones;
    std::array<double, 4> stress{};
    double p = 0, q = 0, phi = 0, plastic_v = 0, plastic_q = 0;
    for (int g = 0; g < 4; ++g) {
      const int i = 4 * static_cast<int>(e) + g;
      zones[g] = solid.updates[i].zone;
      const auto sigma = solid.cauchy(i);
      for (int k = 0; k < 4; ++k) stress[k] += sigma[k] / 4;
      p += solid.updates[i].p / 4;
      q += solid.updates[i].q / 4;
      phi += solid.updates[i].phi / 4;
      const auto plastic = plastic_strain(now.points[i].state);
      plastic_v += plastic.eps_v / 4;
      plastic_q += plastic.eps_q / 4;
    }
    s.zones.push_back(zones);
    s.stress.push_back(stress);
    s.p.push_back(p);
    s.q.push_back(q);
    s.phi.push_back(phi);
    s.plastic_strain_v.push_back(plastic_v);
    s.plastic_strain_q.push_back(plastic_q);
    s.rho_r.push_back(material::relative_density(solid.model, phi));
  }
  return s;
}

CurvePoint SphereRun::row(Branch branch, int branch_id) const {
  CurvePoint point = now.row;
  point.branch = branch;
  point.branch_id = branch_id;
  return point;
}

Curve begun_curve(const Case& c) {
  Curve curve;
  curve.radius_m = c.radius_m;
  curve.sigma_ref_Pa = material::reference_stress(c.material.model);
  curve.E_Pa = material::initial_E(c.material.model);
  curve.nu = material::initial_nu(c.material.model);
  if (const auto* metal = std::get_if<material::VonMises>(&c.material.model))
    if (const auto* hollomon = std::get_if<material::Hollomon>(&metal->hardening))
      curve.inverse_m = hollomon->inverse_m;
  curve.experiment = c.experiment;
  curve.material = c.material.name;
  curve.version = std::string(core::version);
  curve.engine = core::engine;
  return curve;
}

std::vector<double> halts(std::vector<double> some, const std::vector<double>& others, double end) {
  some.insert(some.end(), others.begin(), others.end());
  some.push_back(end);
  std::sort(some.begin(), some.end());
  some.erase(std::unique(some.begin(), some.end()), some.end());
  return some;
}

} // namespace platen::press
