#include "surrogate/description.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace platen::surrogate {
namespace {

double flat(double E, double nu) { return E / (1 - nu * nu); }

Description of(const material::Elastic& m) { return {"elastic", {{"nu", m.nu}}, {m.nu}, m.E, flat(1, m.nu)}; }

/// Poisson's ratio hardly matters beside the flat modulus. Of a metal that hardens it is the flow stress at
/// strains that a contact goes through, whatever the law that says it.
Description of(const material::VonMises& m) {
  const double sigma = material::initial_yield_stress(m.hardening, m.E, m.sigma_y), E_bar = m.E / sigma;
  const double E_flat = flat(E_bar, m.nu);
  if (std::holds_alternative<material::PerfectlyPlastic>(m.hardening))
    return {"von-mises", {{"E_bar", E_bar, true}, {"nu", m.nu}}, {std::log(E_flat), m.nu}, sigma, E_flat};
  const auto grown = [&](double strain) {
    return material::yield_stress(m.hardening, m.E, m.sigma_y, strain).value / sigma;
  };
  Description d{"von-mises-hardening",
                {{"E_bar", E_bar, true},
                 {"nu", m.nu},
                 {"sigma(0.1)/sigma(0)", grown(0.1), true},
                 {"sigma(0.5)/sigma(0)", grown(0.5), true}},
                {std::log(E_flat)},
                sigma,
                E_flat};
  for (const double strain : {0.01, 0.05, 0.2, 0.6}) d.coordinates.push_back(std::log(grown(strain)));
  d.coordinates.push_back(m.nu);
  return d;
}

/// Strengths and moduli over sigma_y, in logarithms, as the granule is and as it will be after plastic volume
/// strains of 0.1 to 0.3: what its contact runs into on the way. Each number of the card moves several of
/// them, but how the force grows follows from where the strengths are, not from the exponents.
std::vector<double> coordinates_of(const material::Vmdc& m) {
  struct At {
    double sigma_y, E, nu, Gamma, b, Lambda;
  };
  const auto at = [&](double phi) -> At {
    const auto f = m.strengths(phi);
    const auto moduli = m.moduli(phi);
    const double sigma_y = f.pi_3 + f.b, E = 9 * moduli.K * moduli.G / (3 * moduli.K + moduli.G);
    return {std::log(sigma_y / m.sigma_y), std::log(E / sigma_y),   E / (2 * moduli.G) - 1,
            std::log(f.Gamma / sigma_y),   std::log(f.b / sigma_y), std::log(f.Lambda / sigma_y)};
  };
  // By plastic volume strains phi.
  const At first = at(0), early = at(0.1), middle = at(0.2), late = at(0.3);
  return {m.rho_r0, first.E, late.E, first.Gamma,  early.Gamma, late.Gamma, early.sigma_y, late.sigma_y,
          first.b,  early.b, late.b, first.Lambda, late.Lambda, first.nu,   middle.nu};
}

Description of(const material::Vmdc& m) {
  return {"vmdc",
          {{"rho_r0", m.rho_r0},
           {"E_bar", m.E / m.sigma_y, true},
           {"nu", m.nu},
           {"Gamma_bar", m.Gamma / m.sigma_y, true},
           {"Lambda_bar", m.Lambda / m.sigma_y, true},
           {"epsilon", m.epsilon},
           {"eta", m.eta},
           {"xi", m.xi},
           {"zeta", m.zeta},
           {"omega", m.omega},
           {"xi_1", m.xi_1},
           {"xi_2", m.xi_2}},
          coordinates_of(m),
          m.sigma_y,
          flat(m.E / m.sigma_y, m.nu)};
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
