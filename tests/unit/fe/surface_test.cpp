#include "fe/surface.hpp"

#include "fe/contact_grid.hpp"
#include "fe/quarter_disc.hpp"
#include "fe/sphere_wedge.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>

using namespace platen;
using fe::Surface;

namespace {

template <class Mesh> double area(const Mesh& mesh) {
  double sum = 0;
  for (const auto& face : Surface<Mesh>(mesh).faces)
    for (const auto& point : face.point) sum += point.area;
  return sum;
}

template <class Mesh> void expect_on_the_sphere(const Mesh& mesh) {
  const Surface<Mesh> surface(mesh);
  ASSERT_EQ(surface.faces.size(), mesh.surface.size());
  for (std::size_t f = 0; f < surface.faces.size(); ++f) {
    const auto& face = surface.faces[f];
    EXPECT_EQ(face.node, mesh.surface[f]);
    for (int k = 0; k < Mesh::face_corners; ++k)
      EXPECT_EQ(mesh.elements[face.element][face.corner[k]], face.node[k]);
    for (const auto& point : face.point) {
      EXPECT_NEAR(fe::norm(point.X), 1, 1e-14);
      EXPECT_GT(point.area, 0);
      double sum = 0;
      for (const double N : point.N) sum += N;
      EXPECT_NEAR(sum, 1, 1e-14);
    }
  }
}

} // namespace

TEST(Surface, OfASectionIsHalfASphere) {
  EXPECT_NEAR(2 * area(fe::quarter_disc(100)), 4 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(2 * area(fe::contact_disc({})), 4 * std::numbers::pi, 1e-12);
}

TEST(Surface, OfAWedgeIsItsShareOfTheSphere) {
  for (const auto kind : {fe::Wedge::octant, fe::Wedge::sixteenth, fe::Wedge::forty_eighth}) {
    const auto mesh = fe::sphere_wedge(kind, 300);
    EXPECT_NEAR(area(mesh) * static_cast<double>(fe::copies(mesh).size()) / (4 * std::numbers::pi), 1, 1e-8);
  }
}

TEST(Surface, HasItsPointsOnTheSphereOverItsElements) {
  expect_on_the_sphere(fe::quarter_disc(100));
  for (const auto kind : {fe::Wedge::octant, fe::Wedge::sixteenth, fe::Wedge::forty_eighth})
    expect_on_the_sphere(fe::sphere_wedge(kind, 300));
}

TEST(Surface, RefusesAFaceWithoutAnElement) {
  auto section = fe::quarter_disc(100);
  section.surface.push_back({section.surface.front()[0], section.surface.back()[1]});
  EXPECT_THROW(Surface<fe::SectionMesh>{section}, std::logic_error);
  auto wedge = fe::sphere_wedge(fe::Wedge::octant, 300);
  wedge.surface.front()[2] = wedge.surface.back()[2];
  EXPECT_THROW(Surface<fe::WedgeMesh>{wedge}, std::logic_error);
}
