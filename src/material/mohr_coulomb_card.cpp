#include "material/mohr_coulomb_card.hpp"

#include "core/error.hpp"
#include "core/number.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace platen::material {
namespace {

using core::Field, core::positive, core::right_open;

constexpr double absent = -1, degree = std::numbers::pi / 180;

struct Given {
  double E = 0, nu = 0;
  double phi = 0, cohesion = absent, sigma_c = absent, psi = absent, cutoff = 0;
};

const std::vector<Field<Given>>& given_fields() {
  static const std::vector<Field<Given>> fields = {
      {"E_Pa", &Given::E, "Young's modulus", positive},
      {"nu", &Given::nu, "Poisson's ratio", right_open(0, 0.5)},
      {"phi_deg", &Given::phi, "friction angle", right_open(0, 90)},
      Field<Given>{"cohesion_Pa", &Given::cohesion, "cohesion", positive}.optional(),
      Field<Given>{"sigma_c_Pa", &Given::sigma_c, "uniaxial compressive strength", positive}.optional(),
      Field<Given>{"psi_deg", &Given::psi, "dilation angle, at most phi; left out: phi, associated flow",
                   right_open(0, 90)}
          .optional(),
      {"tension_cutoff_Pa", &Given::cutoff, "largest principal stress, below the apex cohesion/tan(phi)",
       positive},
  };
  return fields;
}

} // namespace

MohrCoulomb read_mohr_coulomb(const core::Table& table, std::span<const std::string> others) {
  const Given given = core::read_fields(table, given_fields(), {}, others);
  if ((given.cohesion != absent) == (given.sigma_c != absent))
    throw core::InvalidInput(fmt::format("{}: the strength needs exactly one of cohesion_Pa and sigma_c_Pa",
                                         core::place(table, "cohesion_Pa")));
  const double sin_phi = std::sin(given.phi * degree), cos_phi = std::cos(given.phi * degree);
  MohrCoulomb m{};
  m.E = given.E;
  m.nu = given.nu;
  m.phi_deg = given.phi;
  // C = sigma_c (1 - sin(phi))/(2 cos(phi)) (Wang et al., eq. 15).
  m.cohesion = given.cohesion != absent ? given.cohesion : given.sigma_c * (1 - sin_phi) / (2 * cos_phi);
  m.psi_deg = given.psi != absent ? given.psi : given.phi;
  m.cutoff = given.cutoff;
  if (m.psi_deg > m.phi_deg)
    throw core::InvalidInput(fmt::format("{} = {} exceeds phi_deg = {}: plastic flow would give energy back",
                                         core::place(table, "psi_deg"), core::number_text(m.psi_deg),
                                         core::number_text(m.phi_deg)));
  if (m.cutoff * sin_phi >= m.cohesion * cos_phi)
    throw core::InvalidInput(
        fmt::format("{} = {} is not below the apex cohesion/tan(phi) = {} Pa: the cut-off would cut nothing",
                    core::place(table, "tension_cutoff_Pa"), core::number_text(m.cutoff),
                    core::number_text(m.cohesion * cos_phi / sin_phi)));
  return m;
}

const std::vector<Field<MohrCoulomb>>& mohr_coulomb_fields() {
  static const std::vector<Field<MohrCoulomb>> fields = {
      {"E_Pa", &MohrCoulomb::E, "Young's modulus"},
      {"nu", &MohrCoulomb::nu, "Poisson's ratio"},
      {"phi_deg", &MohrCoulomb::phi_deg, "friction angle"},
      {"cohesion_Pa", &MohrCoulomb::cohesion, "cohesion"},
      {"psi_deg", &MohrCoulomb::psi_deg, "dilation angle"},
      {"tension_cutoff_Pa", &MohrCoulomb::cutoff, "largest principal stress"},
  };
  return fields;
}

std::vector<core::FieldInfo> mohr_coulomb_infos() { return {given_fields().begin(), given_fields().end()}; }

} // namespace platen::material
