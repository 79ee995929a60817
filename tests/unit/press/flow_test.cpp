#include "press/flow.hpp"

#include "fe/hexahedron.hpp"
#include "fe/quad.hpp"
#include "fe/quarter_disc.hpp"
#include "fe/sphere_wedge.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace platen;
using press::PointFlow;

namespace {

/// A point that flowed steadily from time 0 to 1, by principal plastic strains of (e, -e).
PointFlow<fe::Quad> flowing(double e) {
  PointFlow<fe::Quad> flow;
  flow.dv = 0.1, flow.dw = 0.2;
  flow.flows = flow.steady = true;
  flow.state = {{std::exp(-2 * e), std::exp(2 * e), 0, 1}, 0.3};
  return flow;
}

constexpr double E = 100, nu = 0.3, sigma_y = 1, G = E / (2 * (1 + nu));

/// Displacements of an isochoric stretch exp(e) of z; the section narrows alike, a body in space along x
/// alone, and is turned about y.
template <class Mesh> std::vector<double> stretched(const Mesh& mesh, double e, double turn = 0) {
  std::vector<double> u;
  for (const auto& X : mesh.nodes) {
    const double x = X[0] * std::exp(Mesh::dim == 2 ? -e / 2 : -e), z = X[Mesh::dim - 1] * std::exp(e);
    u.push_back(std::cos(turn) * x - std::sin(turn) * z - X[0]);
    if (Mesh::dim == 3) u.push_back(0);
    u.push_back(std::sin(turn) * x + std::cos(turn) * z - X[Mesh::dim - 1]);
  }
  return u;
}

/// Uniform flow of a perfectly plastic metal dissipates sigma_y a strain: from yield on, then over a whole
/// step, by whatever angle the body turns meanwhile.
template <fe::Element X>
void expect_plastic_power(const typename X::Mesh& mesh, double eps_q_over_e, double turn_over_e = 0) {
  const fe::Solid<X> solid(mesh, material::VonMises{E, nu, sigma_y});
  fe::Response<X> response;
  std::vector<PointFlow<X>> points(solid.points());
  double time = 0;
  for (const double e : {0.02, 0.03, 0.045, 0.05}) { // the third begins ahead of its equilibrium
    const double next_time = e;
    std::vector<PointFlow<X>> next;
    std::vector<typename X::State> start;
    for (const auto& point : points) {
      next.push_back(press::next_return(point, time, next_time));
      start.push_back(next.back().start);
    }
    EXPECT_EQ(next[0].start_time > time, e > 0.04);
    ASSERT_EQ(solid.evaluate(stretched(mesh, e, turn_over_e * e), start, response), fe::Evaluation::done);
    const double from = time == 0 ? sigma_y / (3 * G) : eps_q_over_e * time;
    for (int i = 0; i < solid.points(); ++i) {
      const double dissipated = press::accept(next[i], points[i], solid.model, response, i);
      ASSERT_NEAR(dissipated, sigma_y * (eps_q_over_e * e - from), 1e-10) << "to " << e;
      EXPECT_TRUE(next[i].flows);
      EXPECT_EQ(next[i].steady, time > 0);
    }
    points = next;
    time = next_time;
  }
}

} // namespace

TEST(Flow, ContinuesSteadyFlowAlmostHalfway) {
  const auto next = press::next_return(flowing(0.1), 1, 2);
  EXPECT_DOUBLE_EQ(next.start_time, 1.45);
  // At a constant rate -ln(C_p^-1)/2 grows in proportion to the time.
  EXPECT_NEAR(next.start.Cp_inv[0], std::exp(-2 * 0.145), 1e-14);
  EXPECT_NEAR(next.start.Cp_inv[1], std::exp(2 * 0.145), 1e-14);
  EXPECT_NEAR(next.start.Cp_inv[2], 0, 1e-14);
  EXPECT_NEAR(next.start.Cp_inv[3], 1, 1e-14);
  EXPECT_NEAR(next.start.phi, 1.45 * 0.3, 1e-14);
  EXPECT_NEAR(next.ahead_dv, 0.45 * 0.1, 1e-15);
  EXPECT_NEAR(next.ahead_dw, 0.45 * 0.2, 1e-15);
}

TEST(Flow, StartsFromTheLastEquilibriumWhereItIsNotSteadyOrTurns) {
  const auto expect_plain = [](const PointFlow<fe::Quad>& last, double next_time) {
    const auto next = press::next_return(last, 1, next_time);
    EXPECT_EQ(next.start_time, 1);
    EXPECT_EQ(next.start, last.state);
    EXPECT_EQ(next.ahead_dv, 0);
    EXPECT_EQ(next.ahead_dw, 0);
  };
  expect_plain(flowing(0.1), 0.9);
  auto begun = flowing(0.1);
  begun.steady = false;
  expect_plain(begun, 2);
  // Backwards is onwards for planes that went back.
  auto back = flowing(0.1);
  back.start_time = 2;
  EXPECT_DOUBLE_EQ(press::next_return(back, 1, 0).start_time, 0.55);
  expect_plain(back, 1.1);
}

TEST(Flow, DissipatesTheYieldStressTimesTheStrain) {
  expect_plastic_power<fe::Quad>(fe::quarter_disc(40), 1);
  const auto body = fe::sphere_wedge(fe::Wedge::octant, 40);
  expect_plastic_power<fe::Hexahedron>(body, 2 / std::sqrt(3));
  expect_plastic_power<fe::Hexahedron>(body, 2 / std::sqrt(3), 20); // 17 degrees a step
}

TEST(Flow, TurnsAStressWithTheMaterial) {
  const double c = std::cos(0.3), s = std::sin(0.3);
  const fe::Quad::Stress in_section{1, -2, 0.5, 1};
  const fe::Quad::Gradient U{1.2, 0.1, 0.1, 0.9}, // its turn by 0.3:
      RU{c * 1.2 - s * 0.1, c * 0.1 - s * 0.9, s * 1.2 + c * 0.1, s * 0.1 + c * 0.9};
  const auto turned = fe::Quad::turned(in_section, {1, 0, 0, 1}, RU);
  EXPECT_NEAR(turned[0], c * c * 1 - 2 * c * s * 0.5 + s * s * -2, 1e-14);
  EXPECT_NEAR(turned[2], c * s * 3 + (c * c - s * s) * 0.5, 1e-14);
  EXPECT_NEAR(turned[0] + turned[1], -1, 1e-14);
  EXPECT_EQ(turned[3], 1);
  const auto back = fe::Quad::turned(turned, RU, {1, 0, 0, 1});
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(back[k], in_section[k], 1e-14);
  for (int k = 0; k < 4; ++k)
    EXPECT_NEAR(fe::Quad::turned(in_section, {1, 0, 0, 1}, U)[k], in_section[k], 1e-14);

  // z to x, the same in space
  const fe::Hexahedron::Stress in_space{1, 0.7, -2, 0.2, -0.3, 0.5}; // xx, yy, zz, xy, yz, zx
  const fe::Hexahedron::Gradient one{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
      moved{{{RU[0], 0, RU[1]}, {0, 1.1, 0}, {RU[2], 0, RU[3]}}};
  const auto there = fe::Hexahedron::turned(in_space, one, moved);
  EXPECT_NEAR(there[0], turned[0], 1e-14);
  EXPECT_NEAR(there[1], 0.7, 1e-14);
  EXPECT_NEAR(there[2], turned[1], 1e-14);
  EXPECT_NEAR(there[5], turned[2], 1e-14);
  EXPECT_NEAR(there[3], c * 0.2 + s * 0.3, 1e-14);
  EXPECT_NEAR(there[4], s * 0.2 - c * 0.3, 1e-14);
}

TEST(Flow, WorksOnTheShearOfAnEvenTurn) {
  for (const double phi : {0.0, 1e-8, 0.1, 0.8, 1.5}) {
    // A unit of shear whose direction turns evenly by phi adds up to a chord, which two halves make up too.
    const double chord = phi > 0 ? 2 * std::sin(phi / 2) / phi : 1, half = chord / (2 * std::cos(phi / 2));
    EXPECT_NEAR(press::working_shear(half, half, std::cos(phi)), 1, 1e-12) << phi;
  }
  EXPECT_EQ(press::working_shear(0, 0.3, 1), 0.3);
  EXPECT_EQ(press::working_shear(0.1, 0.3, -1), 0); // to and fro
}

TEST(Flow, OfAnElasticPointDissipatesNothing) {
  const fe::Solid<fe::Quad> solid(fe::quarter_disc(40), material::VonMises{E, nu, sigma_y});
  fe::Response<fe::Quad> response;
  const std::vector<fe::Quad::State> start(solid.points());
  ASSERT_EQ(solid.evaluate(stretched(solid.mesh, 0.9 * sigma_y / (3 * G)), start, response),
            fe::Evaluation::done);
  for (int i = 0; i < solid.points(); ++i) {
    PointFlow<fe::Quad> flow;
    EXPECT_EQ(press::accept(flow, PointFlow<fe::Quad>{}, solid.model, response, i), 0);
    EXPECT_FALSE(flow.flows || flow.steady);
  }
}
