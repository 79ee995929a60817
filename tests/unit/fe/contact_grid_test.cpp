// The mesh of small contacts.

#include "fe/contact_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace platen;

namespace {

double area(const fe::SectionMesh& mesh, const std::array<int, 4>& quad) {
  double twice = 0;
  for (int k = 0; k < 4; ++k) {
    const auto [r_a, z_a] = mesh.nodes[quad[k]];
    const auto [r_b, z_b] = mesh.nodes[quad[(k + 1) % 4]];
    twice += r_a * z_b - r_b * z_a;
  }
  return twice / 2;
}

} // namespace

TEST(ContactGrid, FillsTheQuarterDiscWithElementsTheRightWayRound) {
  for (const double first : {0.0005, 0.002, 0.02})
    for (const int columns : {8, 20, 33}) {
      const auto mesh = fe::contact_disc({.first_radius = first, .columns = columns});
      double sum = 0;
      for (const auto& quad : mesh.elements) {
        ASSERT_GT(area(mesh, quad), 0);
        sum += area(mesh, quad);
      }
      // Chords leave out about h^2/12 of the length of the arc.
      EXPECT_NEAR(sum, std::numbers::pi / 4, 0.01);
      for (const auto& mirror : mesh.mirrors) { // the axis and the equator
        EXPECT_GT(mirror.nodes.size(), 8u);
        for (const int node : mirror.nodes) EXPECT_EQ(fe::dot(mesh.nodes[node], mirror.normal), 0);
      }
    }
}

TEST(ContactGrid, PutsTheWantedEdgesUnderEveryContactFromTheFirstOn) {
  const auto mesh = fe::contact_disc({});
  EXPECT_EQ(mesh.nodes[mesh.surface.front()[0]][0], 0);
  double before = 0;
  for (const auto& edge : mesh.surface) {
    const auto [r, z] = mesh.nodes[edge[1]];
    EXPECT_NEAR(std::hypot(r, z), 1, 1e-12);
    EXPECT_EQ(mesh.nodes[edge[0]][0], before);
    EXPECT_GT(r, before);
    before = r;
  }
  EXPECT_EQ(mesh.nodes[mesh.surface.back()[1]][1], 0);
  for (double a = 0.002; a < 0.06; a *= 1.1) {
    int edges = 0;
    for (const auto& edge : mesh.surface) edges += mesh.nodes[edge[1]][0] <= a * (1 + 1e-6);
    EXPECT_GE(edges, 20) << a;
  }
}
