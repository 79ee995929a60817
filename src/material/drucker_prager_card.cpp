#include "material/drucker_prager_card.hpp"

#include "core/error.hpp"
#include "core/number.hpp"

#include <fmt/format.h>

#include <cmath>

namespace platen::material {
namespace {

using core::Field, core::positive, core::right_open;

/// atan 3, beyond which sigma_c (1 - tan(beta)/3) = d is negative; reached at phi = 90 degrees.
const double beta_max = std::atan(3.0) * 180 / std::numbers::pi;
constexpr double absent = -1;

struct Given {
  double E = 0, nu = 0;
  double beta = absent, phi = absent, sigma_c = absent, cohesion = absent, psi = absent;
};

const std::vector<Field<Given>>& given_fields() {
  static const std::vector<Field<Given>> fields = {
      {"E_Pa", &Given::E, "Young's modulus", positive},
      {"nu", &Given::nu, "Poisson's ratio", right_open(0, 0.5)},
      Field<Given>{"beta_deg", &Given::beta,
                   "friction angle in the (p, q) plane, below atan 3; with sigma_c_Pa",
                   core::Interval{.low = 0, .high = beta_max}}
          .optional(),
      Field<Given>{"phi_deg", &Given::phi,
                   "friction angle of triaxial compression; with sigma_c_Pa or cohesion_Pa",
                   core::Interval{.low = 0, .high = 90}}
          .optional(),
      Field<Given>{"sigma_c_Pa", &Given::sigma_c, "uniaxial compressive strength", positive}.optional(),
      Field<Given>{"cohesion_Pa", &Given::cohesion, "cohesion of Mohr and Coulomb", positive}.optional(),
      Field<Given>{"psi_deg", &Given::psi,
                   "dilation angle in the (p, q) plane, at most beta; left out: beta, associated flow",
                   right_open(0, beta_max)}
          .optional(),
  };
  return fields;
}

} // namespace

DruckerPrager read_drucker_prager(const core::Table& table, std::span<const std::string> others) {
  const Given given = core::read_fields(table, given_fields(), {}, others);
  const bool beta = given.beta != absent, phi = given.phi != absent, sigma_c = given.sigma_c != absent,
             cohesion = given.cohesion != absent;
  if (beta == phi || sigma_c == cohesion || (beta && cohesion))
    throw core::InvalidInput(fmt::format("{}: the strength needs exactly one of beta_deg with sigma_c_Pa, "
                                         "phi_deg with sigma_c_Pa, phi_deg with "
                                         "cohesion_Pa",
                                         core::place(table, beta ? "beta_deg" : "phi_deg")));
  DruckerPrager m{};
  m.E = given.E;
  m.nu = given.nu;
  m.beta_deg = beta ? given.beta : DruckerPrager::beta_of_friction(given.phi);
  m.sigma_c = sigma_c ? given.sigma_c : DruckerPrager::strength_of_cohesion(given.cohesion, given.phi);
  m.psi_deg = given.psi != absent ? given.psi : m.beta_deg;
  if (m.psi_deg > m.beta_deg)
    throw core::InvalidInput(fmt::format(
        "{} = {} exceeds the friction angle beta = {} in the (p, q) plane: plastic flow would give "
        "energy back",
        core::place(table, "psi_deg"), core::number_text(m.psi_deg), core::number_text(m.beta_deg)));
  return m;
}

const std::vector<Field<DruckerPrager>>& drucker_prager_fields() {
  static const std::vector<Field<DruckerPrager>> fields = {
      {"E_Pa", &DruckerPrager::E, "Young's modulus"},
      {"nu", &DruckerPrager::nu, "Poisson's ratio"},
      {"beta_deg", &DruckerPrager::beta_deg, "friction angle in the (p, q) plane"},
      {"sigma_c_Pa", &DruckerPrager::sigma_c, "uniaxial compressive strength"},
      {"psi_deg", &DruckerPrager::psi_deg, "dilation angle in the (p, q) plane"},
  };
  return fields;
}

std::vector<core::FieldInfo> drucker_prager_infos() { return {given_fields().begin(), given_fields().end()}; }

} // namespace platen::material
