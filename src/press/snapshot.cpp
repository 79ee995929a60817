#include "press/snapshot.hpp"

#include "core/number.hpp"
#include "fe/sphere_wedge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace platen::press {

Zone prevailing(std::span<const Zone> points) {
  std::array<int, 4> count{};
  for (const Zone zone : points) ++count[static_cast<int>(zone)];
  return static_cast<Zone>(count.rend() - std::max_element(count.rbegin(), count.rend()) - 1);
}

template <fe::Element E>
SnapshotOf<E> snapshot(const Stepper<E>& stepper, const State<E>& state, Branch branch) {
  constexpr int dim = E::Mesh::dim;
  const fe::Solid<E>& solid = stepper.solid();
  const fe::Response<E>& response = stepper.response();
  SnapshotOf<E> s;
  s.delta_bar = state.time;
  s.branch = branch;
  const std::vector<double> u = stepper.displacement(state);
  for (std::size_t n = 0; n < solid.mesh.nodes.size(); ++n) {
    auto& moved = s.displacement.emplace_back();
    for (int i = 0; i < dim; ++i) moved[i] = u[dim * n + i];
    s.nodes.push_back(fe::operator+(solid.mesh.nodes[n], moved));
  }
  s.elements = solid.mesh.elements;
  s.surface = solid.mesh.surface;
  if constexpr (dim == 3) s.copies = fe::copies(solid.mesh);
  s.pressure.resize(s.surface.size());
  const auto overlaps = stepper.plan.motion.overlaps_at(state.time);
  std::vector<char> told(stepper.plan.normals.size(), 0);
  for (int k = 0; k < 3; ++k) { // along z, x, y
    const int plane = stepper.plan.plane_of[k], axis = (k + 2) % 3;
    if (plane < 0) continue;
    s.plane[axis] = 1 - overlaps[k];
    if (std::exchange(told[plane], 1)) continue; // images touch images of the mesh
    for (const auto& face : stepper.pressures(state, k)) s.pressure[face.face][axis] = face.pressure;
  }
  for (int e = 0; e < solid.elements(); ++e) {
    typename E::Stress stress{};
    double p = 0, q = 0, phi = 0, plastic_v = 0, plastic_q = 0;
    auto& zones = s.zones.emplace_back();
    for (int g = 0; g < E::points; ++g) {
      const int i = E::points * e + g;
      const auto& update = response.updates[i];
      zones[g] = update.zone;
      const auto sigma = response.cauchy(i);
      for (std::size_t k = 0; k < sigma.size(); ++k) stress[k] += sigma[k] / E::points;
      p += update.p / E::points;
      q += update.q / E::points;
      phi += update.phi / E::points;
      const auto plastic = material::invariants(E::plastic_strain(state.points[i].state));
      plastic_v += plastic.eps_v / E::points;
      plastic_q += plastic.eps_q / E::points;
    }
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
template SnapshotOf<fe::Quad> snapshot(const Stepper<fe::Quad>&, const State<fe::Quad>&, Branch);
template SnapshotOf<fe::Hexahedron> snapshot(const Stepper<fe::Hexahedron>&, const State<fe::Hexahedron>&,
                                             Branch);

PressureProfile profile(const Stepper<fe::Quad>& stepper, const State<fe::Quad>& state) {
  PressureProfile p{state.row.force_N, state.row.contact_radius_m, {}};
  double outer = 0, width = 0;
  for (const auto& ring : stepper.pressures(state, 0)) {
    p.points.push_back({(ring.inner + ring.outer) / 2 * stepper.radius_m, ring.pressure});
    outer = ring.outer;
    width = ring.outer - ring.inner;
  }
  p.points.push_back({(outer + width / 2) * stepper.radius_m, 0.0}); // the first ring that is free
  return p;
}

std::string profile_name(const PressureProfile& p) {
  // A force is met to a share of 1e-5.
  const double force = *core::number_from(fmt::format("{:.4g}", p.force_N));
  return fmt::format("profile-{}.csv", core::number_text(force));
}

std::string profile_csv(const PressureProfile& p) {
  std::string text = fmt::format("# force_N = {}\n# contact_radius_m = {}\nradius_m,pressure_Pa\n",
                                 core::number_text(p.force_N), core::number_text(p.contact_radius_m));
  for (const auto& [r, pressure] : p.points)
    text += fmt::format("{},{}\n", core::number_text(r), core::number_text(pressure));
  return text;
}

} // namespace platen::press
