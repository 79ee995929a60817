#include "press/step.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace platen;

namespace {

const material::VonMises metal{200, 0.3, 1};

/// Loads at even steps.
template <fe::Element E> press::State<E> loaded(press::Stepper<E>& stepper, double to, int steps) {
  auto state = stepper.at_rest();
  for (int i = 1; i <= steps; ++i) {
    auto step = stepper(state, to * i / steps);
    EXPECT_TRUE(step.report.converged()) << fe::words(step.report.cause);
    state = std::move(step.state);
  }
  return state;
}

press::Stepper<fe::Quad> simple() {
  press::Simple e;
  e.elements = 100;
  return {metal, 1, plan(e)};
}

press::Stepper<fe::Hexahedron> hydrostatic() {
  press::Hydrostatic e;
  e.elements = 200;
  return {metal, 1, plan(e)};
}

/// To the last bit.
template <fe::Element E> void expect_same(const press::State<E>& a, const press::State<E>& b) {
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.step, b.step);
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.change, b.change);
  EXPECT_EQ(a.contact.pressure_scale, b.contact.pressure_scale);
  EXPECT_EQ(a.contact.largest_radius, b.contact.largest_radius);
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    const auto &p = a.points[i], &q = b.points[i];
    ASSERT_EQ(p.state, q.state);
    ASSERT_EQ(p.start, q.start);
    ASSERT_EQ(p.direction, q.direction);
    ASSERT_EQ(p.F, q.F);
    const auto numbers = [](const press::PointFlow<E>& f) {
      return std::array{f.start_time, f.ahead_dv, f.ahead_dw, f.dv, f.dw, f.elastic.eps_v, f.elastic.eps_q};
    };
    ASSERT_EQ(numbers(p), numbers(q));
    ASSERT_EQ(p.flows, q.flows);
    ASSERT_EQ(p.steady, q.steady);
  }
  EXPECT_EQ(a.row.force_N, b.row.force_N);
  EXPECT_EQ(a.row.side[0].force_N, b.row.side[0].force_N);
  EXPECT_EQ(a.row.contact_radius_m, b.row.contact_radius_m);
  EXPECT_EQ(a.row_before.force_N, b.row_before.force_N);
  EXPECT_EQ(a.row.work_J, b.row.work_J);
  EXPECT_EQ(a.row.stored_J, b.row.stored_J);
  EXPECT_EQ(a.row.dissipated_J, b.row.dissipated_J);
  EXPECT_EQ(a.row.equator_displacement_m, b.row.equator_displacement_m);
  EXPECT_EQ(a.row.iterations, b.row.iterations);
}

template <fe::Element E> void expect_repeatable(press::Stepper<E>&& stepper) {
  const auto state = loaded(stepper, 0.02, 8), copy = state;
  stepper.forget();
  const auto first = stepper(state, 0.0225);
  ASSERT_TRUE(first.report.converged());
  expect_same(state, copy); // the given state stays what it is
  // Elsewhere, and back.
  ASSERT_TRUE(stepper(first.state, 0.024).report.converged());
  ASSERT_TRUE(stepper(state, 0.0195).report.converged());
  stepper.forget();
  const auto again = stepper(copy, 0.0225);
  EXPECT_EQ(first.report.residuals, again.report.residuals);
  expect_same(first.state, again.state);
}

} // namespace

TEST(Stepper, RepeatsAStepFromACopyToTheLastBit) {
  expect_repeatable(simple());
  expect_repeatable(hydrostatic());
}

TEST(Stepper, IsTheSameInTwoPlaces) {
  auto one = simple(), other = simple();
  const auto state = loaded(one, 0.02, 8);
  expect_same(state, loaded(other, 0.02, 8));
}

TEST(Stepper, LeavesAtRestWhatIsAtRest) {
  auto stepper = simple();
  const auto rest = stepper.at_rest();
  EXPECT_EQ(rest.row.force_N, 0);
  EXPECT_EQ(rest.row.rho_r_mean, 1);
  for (const double u : stepper.displacement(rest)) EXPECT_EQ(u, 0);
}

TEST(Stepper, SaysWhyAStepFailed) {
  auto stepper = simple();
  const auto step = stepper(stepper.at_rest(), 0.4);
  EXPECT_FALSE(step.report.converged());
  EXPECT_NE(fe::words(step.report.cause), "");
}

TEST(Stepper, MovesTheEquatorOfAHydrostaticPressWithItsPlanes) {
  // The equator is the pole of the plane along x: it lies on the plane, up to the penetration and the
  // flatness of the faces around it.
  auto stepper = hydrostatic();
  const auto state = loaded(stepper, 0.04, 10);
  const auto& row = state.row;
  EXPECT_EQ(row.side[0].delta_m, 0.04);
  EXPECT_NEAR(row.equator_displacement_m / -row.side[0].delta_m, 1, 0.02);
  // As does the pole itself.
  const auto u = stepper.displacement(state);
  for (std::size_t n = 0; n < stepper.solid().mesh.nodes.size(); ++n)
    if (std::abs(stepper.solid().mesh.nodes[n][2] - 1) < 1e-12) {
      EXPECT_NEAR(u[3 * n + 2] / row.equator_displacement_m, 1, 1e-9);
    }
}

TEST(Stepper, MovesTheEquatorOfASimplePressOutwards) {
  auto stepper = simple();
  EXPECT_GT(loaded(stepper, 0.04, 10).row.equator_displacement_m, 0);
}

TEST(Stepper, BalancesWorkWithWhatIsStoredAndDissipated) {
  auto stepper = hydrostatic();
  const auto row = loaded(stepper, 0.04, 40).row;
  EXPECT_NEAR((row.stored_J + row.dissipated_J) / row.work_J, 1, 0.005);
}
