#include "material/drucker_prager.hpp"

#include "core/error.hpp"
#include "core/number.hpp"
#include "material/card_section.hpp"

#include <fmt/format.h>

#include <optional>

namespace platen::material {
namespace {

using core::Field, core::positive, core::right_open;

/// atan 3, beyond which sigma_c (1 - tan(beta)/3) = d is negative; reached at phi = 90 degrees.
const double beta_max = std::atan(3.0) * 180 / std::numbers::pi;

/// The strength may be given in three ways, and is written in the first.
struct Given {
  double E = 0, nu = 0;
  std::optional<double> beta, phi, sigma_c, cohesion, psi;
};

DruckerPrager make(const core::Table& table, const Given& given) {
  const auto& [E, nu, beta, phi, sigma_c, cohesion, psi] = given;
  if (beta.has_value() == phi.has_value() || sigma_c.has_value() == cohesion.has_value() ||
      (beta && cohesion))
    throw core::InvalidInput(fmt::format("{}: the strength needs exactly one of beta_deg with sigma_c_Pa, "
                                         "phi_deg with sigma_c_Pa, phi_deg with cohesion_Pa",
                                         core::place(table, beta ? "beta_deg" : "phi_deg")));
  DruckerPrager m{};
  m.E = E;
  m.nu = nu;
  m.beta_deg = beta ? *beta : DruckerPrager::beta_of_friction(*phi);
  m.sigma_c = sigma_c ? *sigma_c : DruckerPrager::strength_of_cohesion(*cohesion, *phi);
  m.psi_deg = psi.value_or(m.beta_deg);
  if (m.psi_deg > m.beta_deg)
    throw core::InvalidInput(fmt::format(
        "{} = {} exceeds the friction angle beta = {} in the (p, q) plane: plastic flow would give "
        "energy back",
        core::place(table, "psi_deg"), core::number_text(m.psi_deg), core::number_text(m.beta_deg)));
  return m;
}

Given given(const DruckerPrager& m) { return {m.E, m.nu, m.beta_deg, {}, m.sigma_c, {}, m.psi_deg}; }

} // namespace

const CardSection<DruckerPrager>& DruckerPrager::card() {
  static const auto section = section_of<DruckerPrager, Given>(
      {
          {"E_Pa", &Given::E, "Young's modulus", positive},
          {"nu", &Given::nu, "Poisson's ratio", right_open(0, 0.5)},
          Field<Given>{"beta_deg", &Given::beta, "friction angle in the (p, q) plane",
                       core::Interval{.low = 0, .high = beta_max}}
              .ruled(", below atan 3; with sigma_c_Pa"),
          {"phi_deg", &Given::phi, "friction angle of triaxial compression; with sigma_c_Pa or cohesion_Pa",
           core::Interval{.low = 0, .high = 90}},
          {"sigma_c_Pa", &Given::sigma_c, "uniaxial compressive strength", positive},
          {"cohesion_Pa", &Given::cohesion, "cohesion of Mohr and Coulomb", positive},
          Field<Given>{"psi_deg", &Given::psi, "dilation angle in the (p, q) plane", right_open(0, beta_max)}
              .ruled(", at most beta; left out: beta, associated flow"),
      },
      make, given, "Exactly one of beta_deg + sigma_c_Pa, phi_deg + sigma_c_Pa, phi_deg + cohesion_Pa.\n");
  return section;
}

} // namespace platen::material
