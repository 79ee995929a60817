#include "press/confined_run.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace platen::press {
namespace {

/// Where planes with the same history are images of each other, one stands for them.
std::array<int, 3> planes_of(const Motion& m) {
  std::array<int, 3> plane{-1, -1, -1};
  int next = 0;
  for (const int axis : {2, 0, 1}) {
    if (!m.present[axis]) continue;
    const bool image =
        (axis == 0 && m.wedge == fe::Wedge::forty_eighth) || (axis == 1 && m.wedge != fe::Wedge::octant);
    plane[axis] = image ? plane[axis == 0 || m.wedge == fe::Wedge::forty_eighth ? 2 : 0] : next++;
  }
  return plane;
}

std::vector<fe::Vector3> normals_of(const std::array<int, 3>& plane) {
  std::vector<fe::Vector3> normals;
  for (const int axis : {2, 0, 1})
    if (plane[axis] == static_cast<int>(normals.size())) {
      fe::Vector3 n{};
      n[axis] = 1;
      normals.push_back(n);
    }
  return normals;
}

/// Between the waypoints of a triaxial history the time grows by the largest change of an overlap.
Motion triaxial_motion(const Case& c) {
  Motion m;
  const std::array<const std::vector<double>*, 3> history{&c.delta_bar_x, &c.delta_bar_y, &c.delta_bar_z};
  for (int axis = 0; axis < 3; ++axis) m.present[axis] = !history[axis]->empty();
  std::vector<std::array<double, 3>> points{{0, 0, 0}};
  std::vector<double> times{0};
  for (std::size_t i = 0; i < c.delta_bar_z.size(); ++i) {
    std::array<double, 3> next{};
    double change = 0, approach = 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (m.present[axis]) next[axis] = (*history[axis])[i];
      change = std::max(change, std::abs(next[axis] - points.back()[axis]));
      approach += next[axis] - points.back()[axis];
    }
    m.retreats.push_back(approach < 0);
    times.push_back(times.back() + change);
    points.push_back(next);
  }
  m.turns.assign(times.begin() + 1, times.end());
  m.end = times.back();
  const bool round = c.delta_bar_x == c.delta_bar_y;
  m.wedge = !round                           ? fe::Wedge::octant
            : c.delta_bar_x == c.delta_bar_z ? fe::Wedge::forty_eighth
                                             : fe::Wedge::sixteenth;
  m.overlaps_at = [points, times](double t) {
    std::size_t leg = 1;
    while (leg + 1 < times.size() && t > times[leg]) ++leg;
    const double share = (t - times[leg - 1]) / (times[leg] - times[leg - 1]);
    std::array<double, 3> at{};
    for (int axis = 0; axis < 3; ++axis)
      at[axis] = t == times[leg] ? points[leg][axis]
                                 : (1 - share) * points[leg - 1][axis] + share * points[leg][axis];
    return at;
  };
  return m;
}

} // namespace

Motion motion_of(const Case& c) {
  if (c.experiment == "triaxial") return triaxial_motion(c);
  Motion m;
  m.end = c.delta_bar_max;
  m.wedge = c.experiment == "hydrostatic" ? fe::Wedge::forty_eighth : fe::Wedge::sixteenth;
  const bool walls = c.experiment != "simple";
  m.present = {walls, walls, true};
  if (c.experiment == "hydrostatic") m.overlaps_at = [](double t) { return std::array{t, t, t}; };
  else m.overlaps_at = [](double t) { return std::array{0.0, 0.0, t}; };
  return m;
}

ConfinedRun::ConfinedRun(const Case& c)
    : radius_m(c.radius_m), sigma_ref(material::reference_stress(c.material.model)), motion(motion_of(c)),
      mesh(fe::sphere_wedge(motion.wedge, c.elements)), solid(mesh.nodes, mesh.hexes, c.material.model),
      plane_of(planes_of(motion)), contact(solid, mesh, normals_of(plane_of), {}),
      halves(static_cast<double>(fe::copies(mesh).size()) / 2) {
  now.u.assign(contact.unknowns(), 0.0);
  now.change = now.u;
  now.points.resize(solid.points());
  now.row.rho_r_mean = now.row.rho_r_min = now.row.rho_r_max = material::relative_density(solid.model, 0);
}

void ConfinedRun::restore(const State& s) {
  now = s;
  contact.u = s.u;
}

fe::StepReport ConfinedRun::advance(double time) {
  const double step = time - now.time;
  const std::array<double, 3> from = motion.overlaps_at(now.time), to = motion.overlaps_at(time);
  std::vector<double> heights, rise;
  for (const int axis : {2, 0, 1})
    if (plane_of[axis] == static_cast<int>(heights.size())) {
      heights.push_back(1 - to[axis]);
      rise.push_back(from[axis] - to[axis]);
    }
  const bool turns = std::find(motion.turns.begin(), motion.turns.end(), now.time) != motion.turns.end();
  // Newton starts from the continued motion: at the converged state itself every plastic point sits on the
  // kink of its yield surface.
  const double ratio = now.step != 0 && !turns ? step / now.step : 0;
  std::vector<double> guess = now.u;
  if (ratio > 0)
    for (std::size_t i = 0; i < guess.size(); ++i) guess[i] += ratio * now.change[i];
  else contact.follow(rise, guess);
  std::vector<Flow> points;
  for (std::size_t i = 0; i < now.points.size(); ++i) {
    if (turns) now.points[i].steady = false;
    points.push_back(next_return(now.points[i], now.time, time));
    solid.committed[i] = points[i].start;
  }
  fe::StepReport report = contact.solve(heights, std::move(guess));
  count(report, counted);
  if (!report.converged) return report;
  for (std::size_t i = 0; i < now.u.size(); ++i) now.change[i] = contact.u[i] - now.u[i];
  now.step = step;
  now.u = contact.u;
  now.time = time;
  account(to, report.iterations, points);
  now.points = std::move(points);
  return report;
}

/// The row of the curve at the new equilibrium.
void ConfinedRun::account(const std::array<double, 3>& overlaps, int iterations, std::vector<Flow>& points) {
  const double R = radius_m, R2 = R * R, R3 = R2 * R;
  const CurvePoint before = now.row;
  CurvePoint row = before;
  row.iterations = iterations;
  double penetration = 0, cell = 8;
  const auto plane = [&](int axis, double& delta, double& force, double& radius, double& mean, double& peak) {
    if (plane_of[axis] < 0) return;
    const fe::Contact c = contact.contact(plane_of[axis]);
    const double before_delta = delta, before_force = force;
    delta = overlaps[axis] * R;
    force = c.force * R2;
    radius = c.radius * R;
    mean = c.radius > 0 ? c.force / (std::numbers::pi * c.radius * c.radius) : 0;
    peak = c.peak_pressure;
    row.work_J += (before_force + force) / 2 * (delta - before_delta);
    penetration += c.energy;
    cell *= 1 - overlaps[axis];
  };
  plane(2, row.delta_m, row.force_N, row.contact_radius_m, row.mean_pressure_Pa, row.peak_pressure_Pa);
  plane(0, row.delta_x_m, row.force_x_N, row.contact_radius_x_m, row.mean_pressure_x_Pa,
        row.peak_pressure_x_Pa);
  plane(1, row.delta_y_m, row.force_y_N, row.contact_radius_y_m, row.mean_pressure_y_Pa,
        row.peak_pressure_y_Pa);
  row.delta_bar = overlaps[2];
  row.F_bar = row.force_N / (std::numbers::pi * R2 * sigma_ref);
  row.hertz_delta_m = row.delta_m;
  if (plane_of[0] >= 0 && plane_of[1] >= 0) row.cell_filling = 4 * std::numbers::pi / 3 / cell;

  const std::vector<double> u = contact.displacements();
  row.mesh_quality = fe::quality(mesh, u).least;
  row.equator_displacement_m = 0;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    if (mesh.nodes[n][0] > 1 - 1e-12) row.equator_displacement_m = u[3 * n] * R;

  const Totals totals = account_points(solid, points, now.points, row);
  row.stored_J = (halves * totals.stored + penetration) * R3;
  row.dissipated_J = before.dissipated_J + halves * totals.dissipated * R3;
  now.row = row;
}

Statistics ConfinedRun::statistics() const {
  return statistics_of(counted, solid, mesh.hexes.size(), contact.unknowns());
}

std::vector<std::string> ConfinedRun::flags() const { return flags_of(solid, now.points); }

CurvePoint ConfinedRun::row(Branch branch, int branch_id) const {
  CurvePoint point = now.row;
  point.branch = branch;
  point.branch_id = branch_id;
  // Legs of a triaxial history on which the planes move apart are branches.
  for (std::size_t leg = 0; leg < motion.retreats.size(); ++leg)
    if (motion.retreats[leg] && now.time > (leg ? motion.turns[leg - 1] : 0) &&
        now.time <= motion.turns[leg]) {
      point.branch = Branch::unloading;
      point.branch_id = static_cast<int>(leg);
    }
  return point;
}

void ConfinedRun::keep(Result& result, Branch branch) const {
  SpatialSnapshot s;
  s.delta_bar = now.time;
  s.branch = branch;
  const auto overlaps = motion.overlaps_at(now.time);
  for (int axis = 0; axis < 3; ++axis) s.plane[axis] = plane_of[axis] < 0 ? 0 : 1 - overlaps[axis];
  const std::vector<double> u = contact.displacements();
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    s.displacement.push_back({u[3 * n], u[3 * n + 1], u[3 * n + 2]});
    s.nodes.push_back(
        {mesh.nodes[n][0] + u[3 * n], mesh.nodes[n][1] + u[3 * n + 1], mesh.nodes[n][2] + u[3 * n + 2]});
  }
  s.hexes = mesh.hexes;
  s.surface = mesh.surface;
  s.copies = fe::copies(mesh);
  s.pressure.resize(mesh.surface.size());
  int plane = 0; // images touch images of the wedge
  for (const int axis : {2, 0, 1})
    if (plane_of[axis] == plane)
      for (const auto& face : contact.pressures(plane++)) s.pressure[face.face][axis] = face.pressure;
  for (std::size_t e = 0; e < mesh.hexes.size(); ++e) {
    fe::Symmetric3 stress{};
    std::array<int, 4> zones{};
    double p = 0, q = 0, phi = 0, plastic_v = 0, plastic_q = 0;
    for (int g = 0; g < 8; ++g) {
      const int i = 8 * static_cast<int>(e) + g;
      const auto sigma = solid.cauchy(i);
      for (int k = 0; k < 6; ++k) stress[k] += sigma[k] / 8;
      zones[static_cast<int>(solid.updates[i].zone)] += 1;
      p += solid.updates[i].p / 8;
      q += solid.updates[i].q / 8;
      phi += solid.updates[i].phi / 8;
      const auto plastic = plastic_strain(now.points[i].state);
      plastic_v += plastic.eps_v / 8;
      plastic_q += plastic.eps_q / 8;
    }
    s.stress.push_back(stress);
    s.zone.push_back(static_cast<Zone>(std::max_element(zones.begin(), zones.end()) - zones.begin()));
    s.p.push_back(p);
    s.q.push_back(q);
    s.phi.push_back(phi);
    s.rho_r.push_back(material::relative_density(solid.model, phi));
    s.plastic_strain_v.push_back(plastic_v);
    s.plastic_strain_q.push_back(plastic_q);
  }
  result.spatial.push_back(std::move(s));
}

} // namespace platen::press
