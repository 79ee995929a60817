#include "fe/solid.hpp"

#include "fe/hexahedron.hpp"
#include "fe/quad.hpp"
#include "fe/quarter_disc.hpp"
#include "fe/sphere_wedge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace platen;

namespace {

const material::VonMises metal{100, 0.3, 1};

template <class Mesh> std::vector<double> flattened(const Mesh& mesh, double by) {
  std::vector<double> u;
  for (const auto& X : mesh.nodes)
    for (int k = 0; k < Mesh::dim; ++k)
      u.push_back((k + 1 == Mesh::dim ? -by : by / 2) * X[k] * (1 + 0.2 * X[0]));
  return u;
}

template <fe::Element E> void expect_same(const fe::Response<E>& a, const fe::Response<E>& b) {
  EXPECT_EQ(a.force, b.force);
  ASSERT_EQ(a.updates.size(), b.updates.size());
  for (std::size_t i = 0; i < a.updates.size(); ++i) {
    ASSERT_EQ(a.updates[i].sigma, b.updates[i].sigma);
    ASSERT_EQ(a.state(static_cast<int>(i)), b.state(static_cast<int>(i)));
  }
}

/// Two questions in turn, the second answer in the place of the first.
template <fe::Element E> void expect_pure(const typename E::Mesh& mesh) {
  const fe::Solid<E> solid(mesh, metal);
  const std::vector<typename E::State> start(solid.points());
  const auto u = flattened(mesh, 0.1), other = flattened(mesh, -0.02);
  fe::Response<E> first, used;
  ASSERT_EQ(solid.evaluate(u, start, first), fe::Evaluation::done);
  ASSERT_EQ(solid.evaluate(other, start, used), fe::Evaluation::done);
  ASSERT_EQ(solid.evaluate(u, start, used), fe::Evaluation::done);
  expect_same(first, used);
  const std::size_t size = E::unknowns * E::unknowns * mesh.elements.size();
  std::vector<double> K(size), again(size, 1.0); // what was there before does not count
  solid.linearise(first, 0.1, K);
  solid.linearise(used, 0.1, again);
  EXPECT_EQ(K, again);
  expect_same(first, used);
}

/// Signs of the natural coordinates of the corners, in the order of fe/mesh.hpp.
constexpr std::array<fe::Vector3, 8> corners{
    {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};

template <fe::Element E> void expect_isoparametric_places(const typename E::Mesh& mesh) {
  const fe::Solid<E> solid(mesh, metal);
  for (int i = 0; i < solid.points(); ++i) {
    const auto& element = mesh.elements[i / E::points];
    const fe::Vector3& at = corners[i % E::points]; // times 1/sqrt(3)
    fe::Vector<E::Mesh::dim> x{};
    for (int a = 0; a < E::Mesh::corners; ++a) {
      double N = 1;
      for (int k = 0; k < E::Mesh::dim; ++k) N *= (1 + corners[a][k] * at[k] / std::sqrt(3)) / 2;
      for (int k = 0; k < E::Mesh::dim; ++k) x[k] += N * mesh.nodes[element[a]][k];
    }
    const auto place = solid.place(i);
    for (int k = 0; k < E::Mesh::dim; ++k) ASSERT_NEAR(place[k], x[k], 1e-14) << i;
  }
}

} // namespace

TEST(Solid, AnswersTheSameQuestionTheSame) {
  expect_pure<fe::Quad>(fe::quarter_disc(40));
  expect_pure<fe::Hexahedron>(fe::sphere_wedge(fe::Wedge::sixteenth, 40));
}

TEST(Solid, HasItsGaussPointsWhereTheIsoparametricMapPutsThem) {
  expect_isoparametric_places<fe::Quad>(fe::quarter_disc(40));
  expect_isoparametric_places<fe::Hexahedron>(fe::sphere_wedge(fe::Wedge::forty_eighth, 40));
}

TEST(Solid, HasItsGaussPointsWhereTheElementsIntegrate) {
  // A section knows the radius of its points: sum of N/R = 1/R.
  const auto section = fe::quarter_disc(40);
  const fe::Solid<fe::Quad> disc(section, metal);
  for (int e = 0; e < disc.elements(); ++e) {
    std::array<fe::Vector<2>, 4> X;
    for (int a = 0; a < 4; ++a) X[a] = section.nodes[section.elements[e][a]];
    const auto shape = fe::Quad::shape(X);
    for (int g = 0; g < 4; ++g) {
      double per_R = 0;
      for (int a = 0; a < 4; ++a) per_R += shape.N_over_R[a][g];
      ASSERT_NEAR(per_R * disc.place(4 * e + g)[0], 1, 1e-13);
    }
  }
  // In a cube of edges 2 the gradients of xy, yz and zx are y and x, z and y, x and z.
  fe::WedgeMesh cube;
  cube.nodes = {corners.begin(), corners.end()};
  cube.elements = {{0, 1, 2, 3, 4, 5, 6, 7}};
  const fe::Solid<fe::Hexahedron> solid(cube, metal);
  const auto shape = fe::Hexahedron::shape(corners);
  for (int g = 0; g < 8; ++g) {
    const auto place = solid.place(g);
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      double slope = 0;
      for (int a = 0; a < 8; ++a) slope += shape.N[g][a][k] * corners[a][k] * corners[a][next];
      EXPECT_NEAR(slope, place[next], 1e-14) << g;
    }
  }
}

TEST(Solid, OnlyResistsWhatIsNoMotionOfTheWhole) {
  // A rotation about z, by 30 degrees, of any points.
  const fe::Solid<fe::Hexahedron> solid(fe::sphere_wedge(fe::Wedge::octant, 40), material::Elastic{1, 0.3});
  const double c = std::sqrt(3) / 2, s = 0.5;
  std::vector<double> u;
  for (const auto& [x, y, z] : solid.mesh.nodes) {
    u.push_back(c * x - s * y - x);
    u.push_back(s * x + c * y - y);
    u.push_back(0.1);
  }
  const std::vector<fe::Hexahedron::State> start(solid.points());
  fe::Response<fe::Hexahedron> response;
  ASSERT_EQ(solid.evaluate(u, start, response), fe::Evaluation::done);
  for (const double force : response.force) EXPECT_NEAR(force, 0, 1e-15);
}
