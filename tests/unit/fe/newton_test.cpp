#include "fe/newton.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

using namespace platen;
using fe::Cause;

namespace {

/// f(x) = 0 of one unknown.
struct Scalar {
  std::function<double(double)> f, slope;
  std::function<Cause(double)> admits = [](double) { return Cause::none; };
  Cause linearised = Cause::none, solved = Cause::none;
  double tangent = 0;
  int evaluations = 0;
  double at = 0;

  Cause evaluate(const std::vector<double>& x, fe::Iterate& iterate) {
    ++evaluations;
    at = x[0];
    iterate.force = {f(at)};
    iterate.relative = std::abs(f(at));
    iterate.touching = {at > 2.5};
    return admits(at);
  }
  Cause linearise(const fe::Iterate&) {
    tangent = slope(at);
    return linearised;
  }
  Cause solve(std::span<double> rhs) {
    rhs[0] /= tangent;
    return solved;
  }
};

Scalar cube() {
  return {[](double x) { return x * x * x - 8; }, [](double x) { return 3 * x * x; }};
}

Cause cause_of(Scalar system, double from, fe::NewtonSettings settings = {}) {
  std::vector x{from};
  return fe::newton(system, settings, x).cause;
}

} // namespace

TEST(Newton, FindsACubeRootQuadratically) {
  Scalar system = cube();
  std::vector x{3.0};
  const auto report = fe::newton(system, {.relative_residual_tolerance = 1e-13}, x);
  ASSERT_TRUE(report.converged());
  EXPECT_NEAR(x[0], 2, 1e-14);
  EXPECT_EQ(report.residuals.size(), static_cast<std::size_t>(report.iterations) + 1);
  // f_(k+1) tends to f''/(2 f'^2) f_k^2 = f_k^2/(3 x^3) = f_k^2/24.
  const auto& r = report.residuals;
  const std::size_t n = r.size() - 2; // the last one is rounding
  EXPECT_NEAR(r[n] / (r[n - 1] * r[n - 1]), 1.0 / 24, 1e-3);
  EXPECT_EQ(system.evaluations, report.iterations + 1) << "no step was shortened";
}

TEST(Newton, SaysWhenAContactChanged) {
  std::vector x{3.0}, y{2.2};
  Scalar system = cube();
  const auto changed = fe::newton(system, {}, x), same = fe::newton(system, {}, y);
  EXPECT_TRUE(changed.contact_changed);
  EXPECT_FALSE(changed.smooth());
  EXPECT_FALSE(same.contact_changed || same.zone_changed);
  EXPECT_TRUE(same.quadratic());
}

TEST(Newton, ShortensStepsAtAStiffKink) {
  // Slope 1 within |x| < 1 and 1/10 beyond: whole steps go from 9 to -9 and back for ever.
  Scalar system{[](double x) { return std::abs(x) < 1 ? x : std::copysign(0.9 + 0.1 * std::abs(x), x); },
                [](double x) { return std::abs(x) < 1 ? 1 : 0.1; }};
  EXPECT_NEAR(9 - system.f(9) / system.slope(9), -9, 1e-12);
  std::vector x{9.0};
  const auto report = fe::newton(system, {}, x);
  EXPECT_TRUE(report.converged());
  EXPECT_NEAR(x[0], 0, 1e-5);
  EXPECT_GT(system.evaluations, report.iterations + 1);
}

TEST(Newton, ShortensStepsThatTurnAnElementInsideOut) {
  Scalar system{[](double x) { return x * x - 1; }, [](double x) { return 2 * x; },
                [](double x) { return x > 1.5 ? Cause::inverted_element : Cause::none; }};
  std::vector x{0.25}; // the whole step leads to 2.125
  EXPECT_TRUE(fe::newton(system, {}, x).converged());
  EXPECT_NEAR(x[0], 1, 1e-5);
}

TEST(Newton, SaysWhyItFoundNothing) {
  for (const Cause cause : {Cause::inverted_element, Cause::refused_material}) {
    Scalar system = cube();
    system.admits = [cause](double) { return cause; };
    EXPECT_EQ(cause_of(system, 3), cause);
  }
  for (const Cause cause : {Cause::singular, Cause::stalled}) {
    Scalar system = cube();
    system.linearised = cause;
    EXPECT_EQ(cause_of(system, 3), cause);
    system = cube();
    system.solved = cause;
    EXPECT_EQ(cause_of(system, 3), cause);
  }
  EXPECT_EQ(cause_of(cube(), 3, {.iterations_max = 2}), Cause::too_many_iterations);
  const Scalar without_root{[](double) { return 2 * fe::diverged; }, [](double) { return 1; }};
  EXPECT_EQ(cause_of(without_root, 3), Cause::diverged);
}

TEST(Newton, HasWordsForEveryCause) {
  std::set<std::string_view> said;
  for (const Cause cause : {Cause::inverted_element, Cause::refused_material, Cause::diverged,
                            Cause::too_many_iterations, Cause::singular, Cause::stalled})
    said.insert(fe::words(cause));
  EXPECT_EQ(said.size(), 6u);
  EXPECT_EQ(said.count(""), 0u);
  EXPECT_EQ(fe::words(Cause::none), "");
}
