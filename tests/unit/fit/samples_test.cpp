#include "fit/samples.hpp"

#include "core/error.hpp"
#include "curves.hpp"
#include "fit/edmans_sinka.hpp"

namespace platen {
namespace {

using test::loading_curve;

/// Errors of c F against F.
fit::Errors errors_of_scaled(const press::Curve& curve, double c) {
  const auto samples = fit::loading_samples(curve);
  std::vector<double> law;
  for (const double F : samples.F_bar) law.push_back(c * F);
  return fit::errors(samples, law);
}

// For F = x and F_law = (1 + s) F by hand: relative L2 = s, e_p = s, and
// e_a = s (X^3/3)^(1/2) / (X^2/2) = s (4/3)^(1/2) X^(-1/2).
TEST(Errors, AreTheClosedFormsForALineOfTheWrongSlope) {
  const auto error = errors_of_scaled(loading_curve([](double x) { return x; }, 2000), 1.03);
  EXPECT_NEAR(error.relative_l2, 0.03, 1e-12);
  EXPECT_NEAR(error.e_p, 0.03, 1e-12);
  EXPECT_NEAR(error.e_a, 0.03 * std::sqrt(4 / 3.0 / 0.5), 1e-7);
}

// docs/notation.md on e_a, (7): it scales as delta^(-1/2). A curve stretched four times in delta has half the
// e_a.
TEST(Errors, TheAreaErrorOfThePaperFallsWithTheRootOfTheOverlap) {
  const auto shape = [](double share) { return share + share * share; };
  const auto narrow = loading_curve([&](double x) { return shape(x / 0.125); }, 100, 0.125);
  const auto wide = loading_curve([&](double x) { return shape(x / 0.5); }, 100, 0.5);
  EXPECT_NEAR(errors_of_scaled(narrow, 1.1).e_a / errors_of_scaled(wide, 1.1).e_a, 2, 1e-10);
  EXPECT_NEAR(errors_of_scaled(narrow, 1.1).relative_l2, errors_of_scaled(wide, 1.1).relative_l2, 1e-12);
}

TEST(Errors, ThePeakErrorCountsALawThatIsTooLow) { // docs/notation.md on e_p, (8): with the absolute value
  EXPECT_NEAR(errors_of_scaled(loading_curve([](double x) { return x; }), 0.9).e_p, 0.1, 1e-12);
}

TEST(Errors, DoNotDependOnWhereTheStepsAreDenser) {
  const auto even = loading_curve([](double x) { return x; }, 4000);
  auto graded = even;
  for (auto& point : graded.points) {
    point.delta_bar = 2 * point.delta_bar * point.delta_bar; // [0, 0.5] onto itself
    point.F_bar = point.delta_bar;
  }
  const auto bent = [](const press::Curve& curve) {
    const auto samples = fit::loading_samples(curve);
    std::vector<double> law;
    for (const double x : samples.delta_bar) law.push_back(x + 0.1 * x * x);
    return fit::errors(samples, law).relative_l2;
  };
  EXPECT_NEAR(bent(even), bent(graded), 1e-7);
}

TEST(Samples, TheWeightsIntegrateFromZeroEvenWhenTheFirstPointIsLater) {
  auto curve = loading_curve([](double x) { return x; }, 100);
  curve.points.erase(curve.points.begin());
  const auto samples = fit::loading_samples(curve);
  double integral = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) integral += samples.weight[i] * samples.F_bar[i];
  EXPECT_NEAR(integral, 0.125, 1e-12); // of x from 0 to 0.5; the trapezoid rule is exact for a line
}

TEST(RSquared, IsOneForThePerfectLawAndZeroForTheMean) {
  const auto samples = fit::loading_samples(loading_curve([](double x) { return x; }));
  EXPECT_DOUBLE_EQ(fit::r_squared(samples, samples.F_bar), 1);
  EXPECT_NEAR(fit::r_squared(samples, std::vector<double>(samples.size(), 0.25)), 0, 1e-12);
}

/// Residuals that are no numbers make Ceres print lines of its own.
TEST(LoadingSamples, ForcesThatCannotBeSquaredAreRefusedInOneSentence) {
  for (const double scale : {1e-300, 1e-80, 1e80, 1e300}) {
    const auto curve = loading_curve([&](double x) { return scale * x; });
    ::testing::internal::CaptureStderr();
    EXPECT_THROW((void)fit::fit_edmans_sinka(curve), core::InvalidInput) << scale;
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "") << scale;
  }
}

} // namespace
} // namespace platen
