#include "fit/unloading.hpp"

#include "core/error.hpp"
#include "curves.hpp"

#include <rapidcheck/gtest.h>

namespace platen {
namespace {

using test::add_unloading, test::loading_curve;

/// (10) for the material of loading_curve(): E_bar = 100, nu = 0.3.
double k_hertz() { return 4 / (3 * std::numbers::pi) * 100 / (1 - 0.09); }

double hertz(double delta_bar) { return k_hertz() * std::pow(delta_bar, 1.5); }

// ES, under (10): Hertz is the special case alpha = 1.5, and by (11) and (12) beta = 1, delta_0 = 0.
TEST(FitUnloading, HertzHasExponentThreeHalvesAndSecantStiffnessOne) {
  auto curve = loading_curve(hertz);
  add_unloading(curve, 1, 0.2, hertz(0.2), 1.5, 0);
  const auto result = fit::fit_unloading(curve);
  ASSERT_EQ(result.fits.size(), 1u);
  const auto& fit = result.fits[0];
  EXPECT_NEAR(fit.alpha, 1.5, 1e-6);
  EXPECT_NEAR(fit.beta, 1, 1e-6);
  EXPECT_NEAR(fit.delta_bar_0, 0, 1e-8);
  EXPECT_NEAR(fit.k / k_hertz(), 1, 1e-5);
  EXPECT_NEAR(fit.r_squared, 1, 1e-12);
  EXPECT_LT(fit.rmse, 1e-8);
}

// Elastic unloading from a flattened contact: shifted Hertz keeps alpha = 1.5 and beta = 1 at any delta_0.
TEST(FitUnloading, AShiftedHertzCurveKeepsItsStiffness) {
  auto curve = loading_curve([](double x) { return 2 * x; });
  const double delta_H = std::pow(0.6 / k_hertz(), 2.0 / 3); // (12)
  add_unloading(curve, 1, 0.3, 0.6, 1.5, 0.3 - delta_H);
  const auto fit = fit::fit_unloading(curve).fits.at(0);
  EXPECT_NEAR(fit.alpha, 1.5, 1e-6);
  EXPECT_NEAR(fit.beta, 1, 1e-6);
}

RC_GTEST_PROP(FitUnloading, RecoversRandomParameters, ()) {
  const auto between = [](double low, double high) {
    return low + (high - low) * (*rc::gen::inRange(0, 100000)) / 100000.0;
  };
  const double x_max = between(0.02, 0.5), x_0 = x_max * between(0.1, 0.97), alpha = between(1.02, 3);
  auto curve = loading_curve([](double x) { return 2 * x; });
  add_unloading(curve, 4, x_max, 2 * x_max, alpha, x_0, *rc::gen::inRange(8, 60));
  const auto fit = fit::fit_unloading(curve).fits.at(0);
  RC_ASSERT(std::abs(fit.alpha - alpha) < 1e-4);
  RC_ASSERT(std::abs(fit.delta_bar_0 - x_0) < 1e-5);
  // (11) with (12)
  RC_ASSERT(std::abs(fit.beta * (x_max - x_0) / std::pow(2 * x_max / k_hertz(), 2.0 / 3) - 1) < 1e-3);
  RC_ASSERT(fit.branch_id == 4);
}

TEST(FitUnloading, TheLawPassesThroughTheTurningPoint) {
  auto curve = loading_curve([](double x) { return 2 * x; });
  add_unloading(curve, 1, 0.3, 0.6, 1.3, 0.25);
  const auto fit = fit::fit_unloading(curve).fits.at(0);
  EXPECT_DOUBLE_EQ(fit.F_bar(0.3), 0.6);
  EXPECT_EQ(fit.F_bar(0.2), 0);
}

// A press may start the branch with the first step down: the turning point is then taken from the loading
// branch.
TEST(FitUnloading, FindsTheTurningPointOnTheLoadingBranch) {
  auto curve = loading_curve([](double x) { return 2 * x; });
  add_unloading(curve, 1, 0.3, 0.6, 1.3, 0.25);
  auto without = curve;
  without.points.erase(without.points.begin() + 201);
  const auto one = fit::fit_unloading(curve).fits.at(0), other = fit::fit_unloading(without).fits.at(0);
  EXPECT_DOUBLE_EQ(other.delta_bar_max, 0.3);
  EXPECT_NEAR(other.alpha, one.alpha, 1e-9);
  EXPECT_EQ(other.points, one.points);
}

TEST(FitUnloading, ABranchThatEndsBeforeSeparationIsFittedFromWhatThereIs) {
  auto curve = loading_curve([](double x) { return 2 * x; });
  add_unloading(curve, 1, 0.3, 0.6, 1.3, 0.25);
  curve.points.resize(curve.points.size() - 20);
  const auto fit = fit::fit_unloading(curve).fits.at(0);
  EXPECT_NEAR(fit.alpha, 1.3, 1e-4);
  EXPECT_NEAR(fit.delta_bar_0, 0.25, 1e-5);
}

TEST(FitUnloading, ZerosAfterSeparationChangeNothing) {
  auto curve = loading_curve([](double x) { return 2 * x; });
  add_unloading(curve, 1, 0.3, 0.6, 1.3, 0.25);
  const auto one = fit::fit_unloading(curve).fits.at(0);
  for (int i = 1; i < 20; ++i) {
    auto point = curve.points.back();
    point.delta_bar -= 0.005;
    point.F_bar = 0;
    curve.points.push_back(point);
  }
  const auto other = fit::fit_unloading(curve).fits.at(0);
  EXPECT_EQ(one.alpha, other.alpha);
  EXPECT_EQ(one.r_squared, other.r_squared);
}

TEST(FitUnloading, OneSidedNoiseKeepsRSquaredAboveThePapersMinimum) { // ES 6.3: minimum 0.998825
  auto curve = loading_curve([](double x) { return 2 * x; });
  add_unloading(curve, 1, 0.3, 0.6, 1.3, 0.25);
  const auto fit = fit::fit_unloading(test::noisy(curve, 0.01, 7)).fits.at(0);
  EXPECT_GT(fit.r_squared, 0.998825);
  EXPECT_NEAR(fit.alpha, 1.3, 0.05);
}

TEST(FitUnloading, SaysWhichBranchIsTooShort) {
  auto curve = loading_curve([](double x) { return 2 * x; });
  add_unloading(curve, 3, 0.3, 0.6, 1.3, 0.25);
  curve.points.resize(201 + 3);
  const auto result = fit::fit_unloading(curve);
  EXPECT_TRUE(result.fits.empty());
  ASSERT_EQ(result.skipped.size(), 1u);
  EXPECT_EQ(result.skipped[0], "unloading branch 3 has 3 points with a force; its fit needs 4");
}

TEST(FitUnloading, RefusesACurveThatDoesNotSayItsElasticity) {
  auto curve = loading_curve([](double x) { return 2 * x; });
  EXPECT_TRUE(fit::fit_unloading(curve).fits.empty()); // nothing to fit, nothing to complain about
  add_unloading(curve, 1, 0.3, 0.6, 1.3, 0.25);
  curve.E_Pa = 0;
  EXPECT_THROW(fit::fit_unloading(curve), core::InvalidInput);
}

} // namespace
} // namespace platen
