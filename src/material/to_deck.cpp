#include "core/error.hpp"
#include "core/number.hpp"
#include "material/deck.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace platen::material {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// Writes one model; stresses in units of the deck.
struct Writer {
  const DeckUnits& units;
  std::vector<std::string> left_over;

  /// Nine digits: the conversion must not show that 1.1e6 is not 1.1 times 1e6 in binary.
  std::string number(double value) const { return fmt::format("{:.9g}", value); }
  std::string stress(double Pa) const { return number(Pa / units.stress); }

  std::string elastic(double E, double nu) const {
    return fmt::format("*Elastic\n {}, {}\n", stress(E), number(nu));
  }

  std::string operator()(const Elastic& m) { return elastic(m.E, m.nu); }

  std::string operator()(const VonMises& m) {
    std::string rows;
    const auto row = [&](double eps, double sigma) {
      rows += fmt::format(" {}, {}\n", stress(sigma), number(eps));
    };
    if (const auto* table = std::get_if<HardeningTable>(&m.hardening))
      for (int i = 0; i < table->size; ++i)
        row(table->strain[static_cast<std::size_t>(i)], table->stress[static_cast<std::size_t>(i)]);
    else if (std::holds_alternative<PerfectlyPlastic>(m.hardening)) row(0, m.sigma_y);
    else {
      constexpr double strains[] = {0,   1e-4, 3e-4, 1e-3, 2e-3, 5e-3, 0.01, 0.02, 0.04, 0.07,
                                    0.1, 0.15, 0.2,  0.3,  0.4,  0.5,  0.7,  1,    1.5,  2};
      for (double eps : strains) row(eps, yield_stress(m.hardening, m.E, m.sigma_y, eps).value);
      left_over.emplace_back("the formula of the hardening: written as points up to a plastic strain of 2");
    }
    return elastic(m.E, m.nu) + "*Plastic\n" + rows;
  }

  std::string operator()(const DruckerPrager& m) {
    return elastic(m.E, m.nu) +
           fmt::format("*Drucker Prager, shear criterion=LINEAR\n {}, {}, {}\n*Drucker Prager Hardening, "
                       "type=COMPRESSION\n {}, 0.\n",
                       number(m.beta_deg), m.circular() ? "1." : number(m.flow_stress_ratio),
                       number(m.psi_deg), stress(m.sigma_c));
  }

  std::string operator()(const MohrCoulomb& m) {
    left_over.emplace_back("flow with the edges of Mohr and Coulomb: Abaqus rounds its potential");
    return elastic(m.E, m.nu) +
           fmt::format("*Mohr Coulomb\n {}, {}\n*Mohr Coulomb Hardening\n {}, 0.\n*Tension Cutoff\n {}, 0.\n",
                       number(m.phi_deg), number(m.psi_deg), stress(m.cohesion), stress(m.cutoff));
  }

  /// Over relative density as field variable 1; the same formulas as in from_deck.cpp, turned round.
  std::string operator()(const Dpc& m) {
    constexpr int steps = 10;
    std::string modulus, cap, hardening;
    for (int i = 0; i <= steps; ++i) {
      const double rho = m.rho_r0 + (1 - m.rho_r0) * i / steps, phi = std::log(rho / m.rho_r0);
      const auto f = m.strengths(phi);
      const double change = rho - m.rho_r0, tan_beta = f.Gamma / (f.Lambda + f.pi_3);
      const double sigma_y = m.sigma_y * std::exp(m.eta * change);
      modulus += fmt::format(" {}, {}, , {}\n", stress(m.E * std::exp(m.xi * change)),
                             number(m.nu + m.xi_1 * change), number(rho));
      cap += fmt::format(" {}, {}, {}, 0., 0., 1., , {}\n", stress(f.Lambda * tan_beta),
                         number(std::atan(tan_beta) / degree), number(f.b / f.Gamma), number(rho));
      hardening += fmt::format(" {}, {}\n", stress(sigma_y), number(phi));
    }
    left_over.emplace_back(
        "the field variable: a subroutine (USDFLD) must set it to the relative density, rho_r0 "
        "times exp(-volumetric plastic strain), tension positive");
    left_over.emplace_back("the arc between line and cap: alpha = 0");
    left_over.emplace_back("flow on the line, which here is pure shear under pressure");
    return fmt::format(
        "*Elastic, dependencies=1\n{}*Cap Plasticity, dependencies=1\n{}*Cap Hardening\n{}*Depvar\n "
        "1,\n*User Defined Field\n",
        modulus, cap, hardening);
  }

  std::string operator()(const Vmdc&) const {
    throw core::InvalidInput(
        "Abaqus has no von Mises Double Cap; write the same numbers as model = \"dpc\" and convert "
        "that, or use a UMAT");
  }
};

} // namespace

DeckText deck_of(const Material& material, const DeckUnits& units) {
  Writer writer{units, {}};
  const std::string model = std::visit(writer, material.model);
  std::string text = fmt::format("** units: {}\n*Material, name=\"{}\"\n", units.words, material.name);
  if (material.density)
    text += fmt::format("*Density\n {},\n", writer.number(*material.density / units.density));
  if (material.tensile_strength) writer.left_over.emplace_back("tensile_strength_Pa, which flags fracture");
  return {text + model, std::move(writer.left_over)};
}

} // namespace platen::material
