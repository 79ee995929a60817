// Against Appendix A of Edmans & Sinka and independent finite elements.
#include "platen/law/edmans_sinka.hpp"
#include "platen/law/edmans_sinka_appendix.hpp"

#include <gtest/gtest.h>

namespace {

using namespace platen::law;

TEST(EdmansSinka, AppendixAPrintedAndCorrected) {
  // Gamma_bar, E_bar; values recomputed by hand from (A.1), (A.2) with the printed and the corrected
  // coefficient
  const auto v = Coefficients::printed;
  const auto c = Coefficients::corrected;
  EXPECT_NEAR(edmans_sinka_appendix(1, 100, c).k, 3.90, 0.005);
  EXPECT_NEAR(edmans_sinka_appendix(0.25, 100, c).k, 1.36, 0.005);
  EXPECT_NEAR(edmans_sinka_appendix(1, 3, c).k, 1.22, 0.005);
  EXPECT_NEAR(edmans_sinka_appendix(1, 500, c).k, 5.13, 0.005);
  EXPECT_NEAR(edmans_sinka_appendix(1, 100, v).k, 0.47, 0.005);
  EXPECT_NEAR(edmans_sinka_appendix(0.25, 100, v).k, 0.50, 0.005);
  EXPECT_NEAR(edmans_sinka_appendix(1, 3, v).k, 0.40, 0.005);
  EXPECT_NEAR(edmans_sinka_appendix(1, 100, c).delta_t, 0.113, 0.0005);
  EXPECT_NEAR(edmans_sinka_appendix(0.25, 100, c).delta_t, 0.081, 0.0005);
  EXPECT_NEAR(edmans_sinka_appendix(1, 100, v).delta_t, 0.51, 0.005);
  EXPECT_NEAR(edmans_sinka_appendix(0.25, 100, v).delta_t, 0.48, 0.005);
  EXPECT_FALSE(edmans_sinka_appendix(1, 100, v).in_range); // no exponential branch left
}

TEST(EdmansSinka, ContactRadiusIsCloseToFiniteElements) {
  // CalculiX 2.20, von Mises, E/sigma_y = 100, nu = 0.3; a/R is within 2 % of converged
  const double x[] = {0.05, 0.1, 0.2, 0.3, 0.4, 0.5}, a[] = {0.310, 0.444, 0.597, 0.711, 0.834, 0.981};
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(edmans_sinka_radius.a_bar(x[i]), a[i], 0.022 * a[i]);
}

} // namespace
