#include "surrogate/description.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace platen::surrogate {
namespace {

Description of(const material::Elastic& m) { return {"elastic", {{"nu", m.nu}}, {m.nu}}; }

/// Perfectly plastic. Poisson's ratio hardly matters beside the flat modulus.
Description of(const material::VonMises& m) {
  if (!std::holds_alternative<material::PerfectlyPlastic>(m.hardening))
    throw core::InvalidInput("no pool has metals that harden yet; `platen derive` presses them");
  const double E_bar = m.E / m.reference_stress();
  return {"von-mises", {{"E_bar", E_bar, true}, {"nu", m.nu}}, {std::log(E_bar / (1 - m.nu * m.nu))}};
}

Description of(const material::Vmdc& m) {
  const double r = m.rho_r0, E_bar = m.E / m.sigma_y, Gamma_bar = m.Gamma / m.sigma_y,
               Lambda_bar = m.Lambda / m.sigma_y;
  return {"vmdc",
          {{"rho_r0", m.rho_r0},
           {"E_bar", E_bar, true},
           {"nu", m.nu},
           {"Gamma_bar", Gamma_bar, true},
           {"Lambda_bar", Lambda_bar, true},
           {"epsilon", m.epsilon},
           {"eta", m.eta},
           {"xi", m.xi},
           {"zeta", m.zeta},
           {"omega", m.omega},
           {"xi_1", m.xi_1},
           {"xi_2", m.xi_2}},
          // A plastic volume strain phi moves rho_r by rho_r0 phi, so rho_r0 goes with every exponent; what
          // counts is which strength grows faster, and how long the cap is beside sigma_y, at first and at
          // full density.
          {r, std::log(E_bar), m.nu, std::log(Gamma_bar), std::log(Lambda_bar),
           std::log(m.epsilon * Gamma_bar), m.eta * r, (m.xi - m.eta) * r, (m.zeta - m.eta) * r,
           (m.omega - m.zeta) * r, m.xi_1 * r,
           std::log(std::max(m.epsilon + m.xi_2 * (1 - r), material::Porous::epsilon_min))}};
}

template <class M> Description of(const M&) {
  throw core::InvalidInput(
      fmt::format("no pool has {} materials yet; `platen derive` presses them", M::name));
}

} // namespace

Description describe(const material::Model& model) {
  return std::visit([](const auto& m) { return of(m); }, model);
}

} // namespace platen::surrogate
