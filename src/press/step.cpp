#include "press/step.hpp"

#include "fe/sphere_wedge.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace platen::press {

using fe::operator*;

template <fe::Element E>
Stepper<E>::Stepper(const material::Model& model, double radius_m_, Plan<E> plan_)
    : plan([&] {
        Plan<E> rest = plan_;
        rest.mesh = {};
        return rest;
      }()),
      radius_m(radius_m_), sigma_ref(material::reference_stress(model)),
      equilibrium(std::move(plan_.mesh), model, plan_.normals, plan_.copies, plan_.contact, plan_.newton) {}

template <fe::Element E> State<E> Stepper<E>::at_rest() const {
  State<E> s;
  s.x.assign(equilibrium.constraints.unknowns(), 0.0);
  s.change = s.x;
  s.points.resize(solid().points());
  s.contact = equilibrium.contact.memory();
  s.row.rho_r_mean = s.row.rho_r_min = s.row.rho_r_max = material::relative_density(solid().model, 0);
  return s;
}

template <fe::Element E> std::vector<double> Stepper<E>::heights(double time) const {
  const auto overlaps = plan.motion.overlaps_at(time);
  std::vector<double> list(plan.normals.size());
  for (int k = 0; k < 3; ++k)
    if (plan.plane_of[k] >= 0) list[plan.plane_of[k]] = 1 - overlaps[k];
  return list;
}

template <fe::Element E> std::vector<double> Stepper<E>::displacement(const State<E>& state) const {
  std::vector<double> u;
  equilibrium.constraints.expand(state.x, u);
  return u;
}

template <fe::Element E>
std::vector<fe::FacePressure> Stepper<E>::pressures(const State<E>& state, int axis) const {
  const int plane = plan.plane_of[axis];
  if (plane < 0) return {};
  return equilibrium.contact.pressures(plane, displacement(state), heights(state.time)[plane], state.contact);
}

template <fe::Element E> Step<E> Stepper<E>::operator()(const State<E>& now, double time) {
  Step<E> result;
  State<E>& next = result.state;
  const auto& turns = plan.motion.turns;
  const bool turn = std::find(turns.begin(), turns.end(), now.time) != turns.end();
  const std::vector<double> from = heights(now.time), to = heights(time);
  next.time = time;
  next.step = time - now.time;
  next.x = now.x;
  // Newton starts from the continued motion: at the converged state itself every plastic point sits on the
  // kink of its yield surface. Planes that turn take what they touch along.
  const double ratio = now.step != 0 && !turn ? next.step / now.step : 0;
  if (ratio > 0)
    for (std::size_t i = 0; i < next.x.size(); ++i) next.x[i] += ratio * now.change[i];
  else {
    const std::vector<double> u = displacement(now);
    for (int k = 0; k < equilibrium.contact.planes(); ++k)
      for (const int node : equilibrium.contact.nodes_touching(k, u, from[k]))
        equilibrium.constraints.move(node, (to[k] - from[k]) * plan.normals[k], next.x);
  }
  std::vector<typename E::State> start;
  start.reserve(now.points.size());
  next.points.reserve(now.points.size());
  for (PointFlow<E> flow : now.points) {
    if (turn) flow.steady = false;
    next.points.push_back(next_return(flow, now.time, time));
    start.push_back(next.points.back().start);
  }
  result.report = equilibrium.solve({to, now.contact, start}, next.x);
  if (!result.report.converged()) return result;
  if constexpr (Plan<E>::Mesh::dim == 3) {
    // An element may fold at a corner and have volume at its Gauss points: equilibrium, but not the
    // particle's.
    if (fe::quality(solid().mesh, equilibrium.displacement()).least <= 0) {
      result.report.cause = fe::Cause::inverted_element;
      return result;
    }
  }
  next.change.resize(next.x.size());
  for (std::size_t i = 0; i < next.x.size(); ++i) next.change[i] = next.x[i] - now.x[i];
  account(next, now, now.contact, result.report.iterations);
  return result;
}

/// What a sphere of finite size is shorter by than two half-spaces (Tatara 1991), at one of its two contacts:
/// F f/(pi E), f = 2(1+nu) R^2/(a^2+4R^2)^{3/2} + (1-nu^2)/(a^2+4R^2)^{1/2}.
template <fe::Element E> double Stepper<E>::far_field(const CurvePoint& row) const {
  const double young = material::initial_E(solid().model), nu = material::initial_nu(solid().model);
  const double l = std::hypot(row.contact_radius_m, 2 * radius_m);
  const double f = 2 * (1 + nu) * radius_m * radius_m / (l * l * l) + (1 - nu * nu) / l;
  return row.force_N * f / (std::numbers::pi * young);
}

/// int F d(delta) between the last two of three rows: of the parabola through them where they follow each
/// other in steps of like size, else of the straight line.
double work_of_step(const PlanePoint& first, const PlanePoint& from, const PlanePoint& to) {
  const double h = to.delta_m - from.delta_m, h_before = from.delta_m - first.delta_m;
  const double line = h * (from.force_N + to.force_N) / 2;
  if (h == 0 || !(h_before / h > 0.25)) return line;
  const double bend =
      ((to.force_N - from.force_N) / h - (from.force_N - first.force_N) / h_before) / (h + h_before);
  return line - bend * h * h * h / 6;
}

/// The row of the curve at the new equilibrium, the flow of its points, and what the contact remembers.
template <fe::Element E>
void Stepper<E>::account(State<E>& next, const State<E>& before, const fe::ContactMemory& memory,
                         int iterations) const {
  const double R = radius_m, R2 = R * R, R3 = R2 * R;
  const std::vector<double>& u = equilibrium.displacement();
  const auto overlaps = plan.motion.overlaps_at(next.time);
  const std::vector<double> height = heights(next.time);
  CurvePoint& row = next.row = before.row;
  next.row_before = before.row;
  row.iterations = iterations;
  std::vector<fe::ContactPatch> patches;
  for (int k = 0; k < equilibrium.contact.planes(); ++k)
    patches.push_back(equilibrium.contact.patch(k, u, height[k], memory));
  double penetration = 0, cell = 8;
  bool closed = true;
  for (int k = 0; k < 3; ++k) {
    closed = closed && plan.plane_of[k] >= 0;
    if (plan.plane_of[k] < 0) continue;
    const fe::ContactPatch& c = patches[plan.plane_of[k]];
    const PlanePoint& last = before.row.plane(k);
    PlanePoint& p = row.plane(k);
    p.delta_m = overlaps[k] * R;
    p.force_N = c.force * R2;
    p.contact_radius_m = c.radius * R;
    p.mean_pressure_Pa = c.radius > 0 ? c.force / (std::numbers::pi * c.radius * c.radius) : 0;
    p.peak_pressure_Pa = c.peak_pressure;
    row.work_J += work_of_step(before.row_before.plane(k), last, p);
    penetration += c.energy;
    cell *= 1 - overlaps[k];
  }
  row.delta_bar = overlaps[0];
  row.F_bar = row.force_N / (std::numbers::pi * R2 * sigma_ref);
  // Beside other planes there is no far field of one contact.
  row.hertz_delta_m = row.delta_m + (plan.normals.size() == 1 && plan.plane_of[1] < 0 ? far_field(row) : 0);
  constexpr int dim = Plan<E>::Mesh::dim;
  const auto& pole = solid().mesh.nodes[plan.equator_node];
  row.equator_displacement_m = 0;
  for (int i = 0; i < dim; ++i) row.equator_displacement_m += u[dim * plan.equator_node + i] * pole[i] * R;
  if constexpr (dim == 3) {
    if (closed) row.cell_filling = 4 * std::numbers::pi / 3 / cell;
    row.mesh_quality = fe::quality(solid().mesh, u).least;
  }
  const Totals totals = account_points(solid(), response(), next.points, before.points, row);
  row.stored_J = (plan.halves * totals.stored + penetration) * R3;
  row.dissipated_J = before.row.dissipated_J + plan.halves * totals.dissipated * R3;
  next.contact = equilibrium.contact.extended(memory, patches, height);
}

template class Stepper<fe::Quad>;
template class Stepper<fe::Hexahedron>;

} // namespace platen::press
