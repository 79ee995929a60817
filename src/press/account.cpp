#include "press/account.hpp"

#include "fe/hexahedron.hpp"
#include "fe/quad.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace platen::press {

template <fe::Element E>
Totals account_points(const fe::Solid<E>& solid, const fe::Response<E>& response,
                      std::vector<PointFlow<E>>& points, const std::vector<PointFlow<E>>& before,
                      CurvePoint& row) {
  Totals totals;
  double reference = 0, unloaded = 0;
  std::array<double, 4> zones{};
  row.rho_r_min = row.rho_r_max = material::relative_density(solid.model, response.updates[0].phi);
  row.sigma_1_max_Pa = row.mises_max_Pa = 0;
  for (int i = 0; i < solid.points(); ++i) {
    const material::PointUpdate& point = response.updates[i];
    const double V = solid.volume(i);
    const double J_p = material::plastic_volume_ratio(solid.model, point.phi);
    reference += V;
    unloaded += V * J_p;
    zones[static_cast<int>(point.zone)] += V;
    const double rho = material::relative_density(solid.model, point.phi);
    row.rho_r_min = std::min(row.rho_r_min, rho);
    row.rho_r_max = std::max(row.rho_r_max, rho);
    row.sigma_1_max_Pa = std::max({row.sigma_1_max_Pa, point.sigma[0], point.sigma[1], point.sigma[2]});
    row.mises_max_Pa = std::max(row.mises_max_Pa, point.q);

    const material::TrialInvariants elastic = material::invariants(point.eps);
    totals.stored += V * J_p * material::stored_energy(solid.model, elastic, point.phi);
    totals.dissipated += V * accept(points[i], before[i], solid.model, response, i);
  }
  row.zone_elastic = zones[0] / reference;
  row.zone_shear = zones[1] / reference;
  row.zone_compaction = zones[2] / reference;
  row.zone_tension = zones[3] / reference;
  row.rho_r_mean = material::relative_density(solid.model, 0) * reference / unloaded;
  return totals;
}

template <fe::Element E>
std::vector<std::string> flags_of(const fe::Solid<E>& solid, const std::vector<PointFlow<E>>& points) {
  double reference = 0, rho_r = 0, nu = 0, epsilon = 0, pi_3 = 0, table = 0;
  for (int i = 0; i < solid.points(); ++i) {
    const material::Bounds b = material::active_bounds(solid.model, points[i].state.phi);
    const double V = solid.volume(i);
    reference += V;
    rho_r += V * b.rho_r;
    nu += V * b.nu;
    epsilon += V * b.epsilon;
    pi_3 += V * b.pi_3;
    table += V * b.table;
  }
  std::vector<std::string> said;
  const auto say = [&](double volume, const char* what) {
    if (volume > 0)
      said.push_back(std::string(what) + " in " + std::to_string(100 * volume / reference).substr(0, 4) +
                     " % of the volume at the end of the press");
  };
  say(rho_r, "relative density beyond 1, properties held at their values for 1,");
  say(nu, "Poisson's ratio held in [0, 0.49]");
  say(epsilon, "axis ratio of the compaction cap held at its minimum 0.05");
  say(pi_3, "compaction cap centred at p = 0, since epsilon Gamma exceeds sigma_y,");
  say(table, "strain beyond the end of the hardening table, its last stress held,");
  return said;
}

template Totals account_points(const fe::Solid<fe::Quad>&, const fe::Response<fe::Quad>&,
                               std::vector<PointFlow<fe::Quad>>&, const std::vector<PointFlow<fe::Quad>>&,
                               CurvePoint&);
template Totals account_points(const fe::Solid<fe::Hexahedron>&, const fe::Response<fe::Hexahedron>&,
                               std::vector<PointFlow<fe::Hexahedron>>&,
                               const std::vector<PointFlow<fe::Hexahedron>>&, CurvePoint&);
template std::vector<std::string> flags_of(const fe::Solid<fe::Quad>&,
                                           const std::vector<PointFlow<fe::Quad>>&);
template std::vector<std::string> flags_of(const fe::Solid<fe::Hexahedron>&,
                                           const std::vector<PointFlow<fe::Hexahedron>>&);

} // namespace platen::press
