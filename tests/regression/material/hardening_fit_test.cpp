// Shahin's lead, its Ludwik and Hollomon laws beside each other. His yield stress is not printed: 5 MPa is
// inferred from the pair itself (lead, sections 2.1 and 3.1), so that this is a regression test, not a
// verification.

#include "hardening_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace platen::material;

namespace {
constexpr double E = 10e9, sigma_y = 5e6;
const Ludwik lead{15.5e6, 1 / 2.857};
} // namespace

TEST(HardeningFit, LeadsLudwikLawReturnsItsPrintedHollomonLaw) {
  // Printed: kappa = 20.5 MPa, m = 4.167; over strains from 0 to 1.5.
  const Hollomon law = fit_hollomon(lead, sigma_y, E, 1.5);
  EXPECT_NEAR(law.kappa, 20.50e6, 0.02e6);
  EXPECT_NEAR(1 / law.inverse_m, 4.167, 0.02); // 4.153: it depends a little on where the strains are taken
}

TEST(HardeningFit, GoesThereAndBack) {
  const Hollomon law = fit_hollomon(lead, sigma_y, E, 1.5);
  const LudwikFit back = fit_ludwik(law, E, 1.5);
  for (double eps_p = 0.05; eps_p <= 1.5; eps_p += 0.05)
    EXPECT_NEAR(yield_stress(back.law, E, back.sigma_y, eps_p).value,
                yield_stress(lead, E, sigma_y, eps_p).value, 0.5e6)
        << eps_p;
  const Hollomon again = fit_hollomon(back.law, back.sigma_y, E, 1.5);
  EXPECT_NEAR(again.kappa, law.kappa, 1e-3 * law.kappa);
  EXPECT_NEAR(again.inverse_m, law.inverse_m, 2e-3);
}
