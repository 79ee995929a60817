// An elastic sphere of finite size, docs/laws/hertz.md: F = F_Hertz (1 + 0.55 sqrt(delta_bar)) for nu = 0.3.
// Unloading retraces it, and its fit has closed bounds.

#include "fit/edmans_sinka.hpp"
#include "fit/unloading.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace platen {
namespace {

/// Loaded in 100 steps, unloaded in the same; the turning point starts the unloading branch again.
press::Curve elastic_sphere(double delta_bar_max) {
  press::Curve curve;
  curve.radius_m = 1e-3;
  curve.sigma_ref_Pa = 1e8;
  curve.E_Pa = 1e10;
  curve.nu = 0.3;
  const double k_H = 4 / (3 * std::numbers::pi) * 100 / (1 - 0.09); // ES (10)
  for (int i = 0; i <= 201; ++i) {
    press::CurvePoint point;
    point.branch = i <= 100 ? press::Branch::loading : press::Branch::unloading;
    point.branch_id = i <= 100 ? 0 : 1;
    point.delta_bar = delta_bar_max * (i <= 100 ? i : 201 - i) / 100;
    point.F_bar = k_H * std::pow(point.delta_bar, 1.5) * (1 + 0.55 * std::sqrt(point.delta_bar));
    curve.points.push_back(point);
  }
  return curve;
}

// d ln F/d ln x = 1.5 + 0.275 sqrt(x)/(1 + 0.55 sqrt(x)) rises with x; for a power of x - x_0 with x_0 > 0 it
// would fall. So the fit has delta_0 = 0, alpha between the slopes at both ends, and by (11) beta =
// (F/F_Hertz)^(2/3).
TEST(ElasticSphere, UnloadsWithoutSeparationOverlapAndStifferThanHertz) {
  for (const double x : {0.001, 0.005, 0.05}) {
    const auto fit = fit::fit_unloading(elastic_sphere(x)).fits.at(0);
    const double stiffening = 1 + 0.55 * std::sqrt(x);
    EXPECT_NEAR(fit.delta_bar_0, 0, 1e-6 * x);
    EXPECT_GT(fit.alpha, 1.5);
    EXPECT_LT(fit.alpha, 1.5 + 0.275 * std::sqrt(x) / stiffening);
    EXPECT_NEAR(fit.beta, std::pow(stiffening, 2.0 / 3), 1e-6);
    EXPECT_GT(fit.r_squared, 0.99999);
  }
}

// ES Appendix A: soft particles, which stay elastic for long, depart most from the linear first branch. The
// Hertz-like first branch must then fit better than the published form.
TEST(ElasticSphere, IsFittedBestByTheHertzLikeFirstBranch) {
  const auto comparison = fit::fit_best(elastic_sphere(0.3));
  EXPECT_EQ(comparison.fits.front().variant, law::EdmansSinkaVariant::hertz_like) << comparison.verdict;
}

} // namespace
} // namespace platen
