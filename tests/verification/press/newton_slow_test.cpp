// The tangent is consistent: where neither contact nor zones change, Newton's residuals fall quadratically
// down to rounding.

#include "press/step.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

using namespace platen;

namespace {

/// Loads to a tenth of the radius, then goes on in small steps, which cross few kinks.
void expect_quadratic(const material::Model& model) {
  const press::Simple e;
  auto plan = press::plan(e);
  plan.newton.relative_residual_tolerance = 1e-12;
  press::Stepper<fe::Quad> stepper(model, 1e-3, std::move(plan));
  auto state = stepper.at_rest();
  const auto advance = [&](double by) {
    auto next = stepper(state, state.time + by);
    if (next.report.converged()) state = std::move(next.state);
    return next.report;
  };
  double step = 1e-4;
  while (state.time < 0.1) {
    step = advance(step).converged() ? std::min(1.5 * step, e.step_max) : step / 2;
    ASSERT_GT(step, 1e-7);
  }
  constexpr int steps = 100;
  int smooth = 0, quadratic = 0;
  for (int i = 0; i < steps; ++i) { // uneven, or the continued motion would be too near for two iterations
    const fe::StepReport report = advance(i % 2 == 0 ? 0.8e-5 : 1.6e-5);
    smooth += report.smooth();
    quadratic += report.quadratic();
  }
  std::printf("%d of %d steps without change of contact or zone, %d of them quadratic\n", smooth, steps,
              quadratic);
  EXPECT_GE(quadratic, 20);
  EXPECT_EQ(quadratic, smooth);
}

} // namespace

TEST(Newton, IsQuadraticForAMetal) { expect_quadratic(material::VonMises{100e6, 0.3, 1e6}); }
TEST(Newton, IsQuadraticForAGranule) {
  expect_quadratic(material::Vmdc{0.7, 150e6, 15e9, 0.3, 150e6, 1.5e6, 0.7, 10, 7.5, 10, 10, 0.4, 1.5});
}
