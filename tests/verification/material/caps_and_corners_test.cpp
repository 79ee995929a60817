// Porous materials and Mohr-Coulomb against closed forms.

#include "material/point.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace platen::material;

namespace {

constexpr double degree = std::numbers::pi / 180;

/// ES Table 6, in units of its sigma_y, with another stiffness.
Vmdc base_case(double E_bar) { return {0.7, 1, E_bar, 0.3, 1, 0.01, 0.7, 10, 7.5, 10, 10, 0.4, 1.5}; }

MaterialPoint led(const Model& model, std::array<double, 3> increment, int steps) {
  MaterialPoint point;
  for (int i = 0; i < steps; ++i) {
    point = strained(model, point, increment);
    EXPECT_FALSE(is_refused(point.last.status)) << "step " << i;
  }
  return point;
}

} // namespace

TEST(ClosedForm, BothCapModelsYieldAtTheHydrostaticStrengthOfTheirDensity) {
  // ES (3a), (4a): p = -sigma_y0 exp(eta (rho_r - rho_r0)), rho_r = rho_r0 exp(phi).
  for (const Model& model : {Model(base_case(100)), Model(Dpc::through(base_case(100)))}) {
    const MaterialPoint point = led(model, {-0.001, -0.001, -0.001}, 100);
    const double rho_r = relative_density(model, point.phi);
    EXPECT_EQ(point.last.zone, Zone::compaction);
    EXPECT_NEAR(rho_r, 0.7 * std::exp(0.3 + point.elastic[0] * 3), 1e-12);
    EXPECT_NEAR(point.last.p, -std::exp(10 * (rho_r - 0.7)), 1e-8);
  }
}

TEST(ClosedForm, UniaxialStrainFlowsWhereTheCapsNormalIsUniaxial) {
  // Without elastic strain d(eps_v^p) : d(eps_q^p) = -1 : 2/3. The normal of an ellipse with semi-axes b,
  // q_top at p = -pi_3 - b sin(t), q = q_top cos(t) has that direction at tan(t) = 3 b/(2 q_top), b = epsilon
  // Gamma.
  const Vmdc stiff = base_case(1e6);
  const MaterialPoint vmdc = led(stiff, {-0.002, 0, 0}, 100);
  const auto f = stiff.surface(vmdc.phi);
  const double t = std::atan(1.5 * f.b / f.Gamma), unit = std::exp(10 * (stiff.rho_r(vmdc.phi) - 0.7));
  EXPECT_NEAR(vmdc.phi, 0.2, 1e-5);
  EXPECT_NEAR(vmdc.last.p, -f.pi_3 - f.b * std::sin(t), 1e-4 * unit);
  EXPECT_NEAR(vmdc.last.q, f.Gamma * std::cos(t), 1e-4 * unit);

  const Dpc other = Dpc::through(stiff);
  const MaterialPoint dpc = led(other, {-0.002, 0, 0}, 100);
  const auto g = other.surface(dpc.phi);
  const double top = g.at(g.pi_3.x).q, u = std::atan(1.5 * g.b.x / top);
  EXPECT_NEAR(dpc.last.p, -g.pi_3.x - g.b.x * std::sin(u), 1e-4 * unit);
  EXPECT_NEAR(dpc.last.q, top * std::cos(u), 1e-4 * unit);
}

TEST(EquivalentSurfaces, MeetInTheFourPointsOfTheirTable3) {
  // VM, VMDC and DPC through (sigma_y, Gamma, Lambda, epsilon); the DPC's top is below Gamma by its arc, at
  // most 2 %.
  for (const double phi : {-0.1, 0.0, 0.2, 0.3}) {
    const Vmdc m = base_case(100);
    const auto v = m.surface(phi);
    const auto d = std::get<Dpc>(run_as(m, "dpc")).surface(phi);
    EXPECT_NEAR(d.at(d.s_min()).p, v.at(v.s_min()).p, 1e-12) << "tension";
    EXPECT_NEAR(d.at(d.s_max()).p, v.at(v.s_max()).p, 1e-12 * v.b) << "hydrostatic compression";
    const double top = d.at(v.pi_3).q;
    EXPECT_LE(top, v.Gamma);
    EXPECT_GE(top, 0.98 * v.Gamma);
    EXPECT_EQ(d.at(v.pi_3).n_p, 0) << "the top flows without change of volume";
  }
  EXPECT_EQ(std::get<VonMises>(run_as(base_case(100), "von-mises")).sigma_y, 1);
}

TEST(ClosedForm, MohrCoulombCarriesItsTriaxialLimitLoads) {
  // sigma_1 (1 + sin phi) - sigma_3 (1 - sin phi) = 2 C cos(phi); WG section 3.4, item (b).
  const double phi = 27.8, C = 3.2e6, sin_phi = std::sin(phi * degree), cos_phi = std::cos(phi * degree);
  for (const double psi : {0.0, 10.0, phi}) {
    const Model model = MohrCoulomb{10e9, 0.38, phi, C, psi, 1e6};
    for (const double lateral : {0.0, -5e6, -50e6}) {
      MaterialPoint compressed, extended;
      for (int i = 0; i < 100; ++i) {
        compressed = strained_axially(model, compressed, -3e-4 * (1 - lateral / 10e6), lateral);
        ASSERT_FALSE(is_refused(compressed.last.status));
      }
      EXPECT_NEAR(compressed.last.sigma[0], (lateral * (1 + sin_phi) - 2 * C * cos_phi) / (1 - sin_phi), 10);
      for (int i = 0; i < 100; ++i) {
        extended = strained_axially(model, extended, 2e-4, lateral);
        ASSERT_FALSE(is_refused(extended.last.status));
      }
      const double shear_limit = (lateral * (1 - sin_phi) + 2 * C * cos_phi) / (1 + sin_phi);
      EXPECT_NEAR(extended.last.sigma[0], std::min(shear_limit, 1e6), 10) << lateral;
    }
  }
}

TEST(ClosedForm, MohrCoulombAndDruckerPragerAgreeInTriaxialCompression) {
  // WG (6), (7), (15): the circle passes through the outer corners of the hexagon.
  const double phi = 27.8, C = 3.2e6;
  const MohrCoulomb mohr{10e9, 0.38, phi, C, 0, 1e6};
  const double beta = DruckerPrager::beta_of_friction(phi);
  const DruckerPrager drucker{10e9, 0.38, beta, DruckerPrager::strength_of_cohesion(C, phi), 0};
  for (const double lateral : {0.0, -10e6}) {
    MaterialPoint a, b;
    for (int i = 0; i < 100; ++i) {
      a = strained_axially(mohr, a, -5e-4, lateral);
      b = strained_axially(drucker, b, -5e-4, lateral);
    }
    EXPECT_NEAR(a.last.sigma[0], b.last.sigma[0], 1e-6 * std::abs(a.last.sigma[0]));
  }
}
