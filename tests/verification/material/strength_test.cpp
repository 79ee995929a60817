// Hardening and friction against closed forms.

#include "material/point.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace platen::material;

namespace {

constexpr double degree = std::numbers::pi / 180;

/// A point strained along the first axis while the stress on the two others stays `lateral`.
struct Triaxial {
  const Model& model;
  double lateral = 0;
  MaterialPoint point{};

  const PointUpdate& last() const { return point.last; }
  void strain_by(double increment) {
    point = strained_axially(model, point, increment, lateral);
    ASSERT_FALSE(is_refused(point.last.status));
  }
};

} // namespace

TEST(ClosedForm, HollomonInUniaxialStressIsItsPowerOfTheStrain) {
  // sigma = kappa eps^{1/m}; with E/kappa = 1000 the elastic strain is that of small strains to 1e-6.
  const double E = 1e9, kappa = 1e6;
  for (const double inverse_m : {0.1, 0.25, 0.5}) {
    const Hollomon law{kappa, inverse_m};
    const Model model = VonMises{E, 0.3, initial_yield_stress(law, E, 0), law};
    Triaxial bar{model};
    for (int i = 1; i <= 100; ++i) {
      bar.strain_by(0.005);
      EXPECT_NEAR(bar.last().sigma[0], kappa * std::pow(bar.point.total[0], inverse_m), 2e-6 * kappa)
          << inverse_m;
    }
  }
}

TEST(ClosedForm, LudwikInUniaxialStressIsItsPowerOfThePlasticStrain) {
  // Shahin (2.1), (2.2), his lead: sigma = sigma_y + K eps_p^{1/n}, eps_p = eps - sigma/E.
  const double E = 10e9, sigma_y = 5e6, K = 15.5e6, inverse_n = 1 / 2.857;
  const Model model = VonMises{E, 0.435, sigma_y, Ludwik{K, inverse_n}};
  Triaxial bar{model};
  for (int i = 1; i <= 100; ++i) {
    bar.strain_by(0.01);
    const double eps_p = bar.point.total[0] - bar.last().sigma[0] / E;
    EXPECT_NEAR(bar.last().sigma[0], sigma_y + K * std::pow(eps_p, inverse_n), 1e-5 * sigma_y);
  }
}

TEST(ClosedForm, DruckerPragerCarriesItsTriaxialLimitLoads) {
  // Compression under sigma_3: q = d - p tan(beta) with p = sigma_3 - q/3; extension: p = sigma_3 + q/3.
  const double sigma_c = 10.61e6, beta = 47.84; // WG section 3.4
  const double tan_beta = std::tan(beta * degree), d = sigma_c * (1 - tan_beta / 3);
  for (const double psi : {0.0, 20.0, beta}) {
    const Model model = DruckerPrager{10e9, 0.38, beta, sigma_c, psi};
    for (const double sigma_3 : {0.0, -5e6, -50e6}) {
      Triaxial compressed{model, sigma_3}, extended{model, sigma_3};
      for (int i = 0; i < 100; ++i) compressed.strain_by(-2e-4 * (1 - sigma_3 / 10e6));
      EXPECT_NEAR(compressed.last().q, (d - sigma_3 * tan_beta) / (1 - tan_beta / 3), 1e-6 * sigma_c);
      for (int i = 0; i < 100; ++i) extended.strain_by(2e-4 * (1 - sigma_3 / 10e6));
      EXPECT_NEAR(extended.last().q, (d - sigma_3 * tan_beta) / (1 + tan_beta / 3), 1e-6 * sigma_c);
    }
    Triaxial crushed{model};
    for (int i = 0; i < 100; ++i) crushed.strain_by(-2e-4);
    EXPECT_NEAR(crushed.last().sigma[0], -sigma_c, 1e-6 * sigma_c) << "uniaxial compressive strength";
  }
}

TEST(ClosedForm, DruckerPragerOfAnotherSectionCarriesLessInExtension) {
  // t = q in compression, q/K in extension (Abaqus, linear model): there q = K (d - sigma_3 tan(beta))/(1 + K
  // tan(beta)/3).
  const double sigma_c = 10.61e6, beta = 47.84, K = 0.778;
  const double tan_beta = std::tan(beta * degree), d = sigma_c * (1 - tan_beta / 3);
  for (const double psi : {0.0, 20.0, beta}) {
    const Model model = DruckerPrager{10e9, 0.38, beta, sigma_c, psi, K};
    for (const double sigma_3 : {0.0, -5e6, -50e6}) {
      Triaxial compressed{model, sigma_3}, extended{model, sigma_3};
      for (int i = 0; i < 100; ++i) compressed.strain_by(-2e-4 * (1 - sigma_3 / 10e6));
      EXPECT_NEAR(compressed.last().q, (d - sigma_3 * tan_beta) / (1 - tan_beta / 3), 1e-6 * sigma_c);
      for (int i = 0; i < 100; ++i) extended.strain_by(2e-4 * (1 - sigma_3 / 10e6));
      EXPECT_NEAR(extended.last().q, K * (d - sigma_3 * tan_beta) / (1 + K * tan_beta / 3), 1e-6 * sigma_c);
    }
  }
}

TEST(ClosedForm, DruckerPragerDilatesAsItsAngleSays) {
  for (const double psi : {0.0, 20.0, 47.84}) {
    const Model model = DruckerPrager{10e9, 0.38, 47.84, 10.61e6, psi};
    Triaxial bar{model};
    for (int i = 0; i < 50; ++i) bar.strain_by(-2e-4);
    EXPECT_NEAR(bar.last().dv, bar.last().dw * std::tan(psi * degree), 1e-12);
  }
}

TEST(ClosedForm, DruckerPragerTornApartStaysAtItsApex) {
  const DruckerPrager rock{10e9, 0.38, 47.84, 10.61e6, 10};
  const auto apex = rock.surface(0).p_apex();
  const std::array<double, 3> torn{0.01, 0.012, 0.009};
  const double phi = 0;
  PointUpdate u{};
  ASSERT_EQ(update(rock, {&torn, 1}, {&phi, 1}, {&u, 1}).refused, 0);
  EXPECT_EQ(u.zone, Zone::tension);
  for (const double s : u.sigma) EXPECT_NEAR(s, apex, 1e-9 * apex);
}

TEST(WangStrengths, AreThoseOfTheirSection34) {
  // WG (14), (15) with phi = 27.8 degrees and sigma_c = 10.61 MPa give the printed sigma_Y = 6.70, C = 3.2
  // MPa.
  const double phi = 27.8, sigma_c = 10.61;
  const DruckerPrager rock{1e4, 0.38, DruckerPrager::beta_of_friction(phi), sigma_c, 0};
  const double sin_phi = std::sin(phi * degree);
  EXPECT_NEAR(rock.surface(0).d, 3 * (1 - sin_phi) / (3 - sin_phi) * sigma_c, 1e-12 * sigma_c);
  EXPECT_NEAR(rock.surface(0).d, 6.70, 0.005);
  EXPECT_NEAR(DruckerPrager::strength_of_cohesion(3.2, phi), sigma_c, 0.01);
  EXPECT_NEAR(rock.beta_deg, 47.84, 0.01);
}
