// The main job on Edmans & Sinka's base case, against what their paper says of its law.

#include "fit/edmans_sinka.hpp"
#include "press/press.hpp"

#include <gtest/gtest.h>

using namespace platen;

TEST(BaseCase, LawAgreesWithTheCorrectedAppendix) {
  // ES (A.1)-(A.3) at Gamma_bar = 1, E_bar = 100, with a_1 = 7.4613e-1 in A.1 and a_6 = 4.3846e-2 in A.2:
  // regressions over 160 presses with R^2 = 0.98, 0.87, 0.71, so that k is told closely and the others
  // roughly.
  constexpr double k = 3.90, delta_t = 0.113, a = 3.65;
  const press::Result result = press::press(
      {{"base case", material::Vmdc{0.7, 150e6, 15e9, 0.3, 150e6, 1.5e6, 0.7, 10, 7.5, 10, 10, 0.4, 1.5}}});
  ASSERT_FALSE(result.failure) << *result.failure;
  const auto fitted = fit::fit_edmans_sinka(result.curve);
  std::printf("k %.3f, delta_t %.4f, a %.3f; relative L2 %.2f %%, e_p %.2f %%\n", fitted.k, fitted.delta_t,
              fitted.a, 100 * fitted.errors.relative_l2, 100 * fitted.errors.e_p);
  EXPECT_NEAR(fitted.k, k, 0.05 * k);
  EXPECT_NEAR(fitted.delta_t, delta_t, 0.2 * delta_t);
  EXPECT_NEAR(fitted.a, a, 0.1 * a);
  // The form cannot follow this curve more closely: see docs/explanation/edmans-sinka-fit.md.
  EXPECT_LT(fitted.errors.relative_l2, 0.046);
  EXPECT_LT(fitted.errors.e_p, 0.065);
}
