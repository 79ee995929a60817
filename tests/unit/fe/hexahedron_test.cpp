// The solid in space and the wedges of the sphere that it fills.

#include "fe/hexahedron.hpp"
#include "fe/sphere_wedge.hpp"
#include "solids.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using namespace platen;
using fe::operator-;

namespace {

using Solid = fe::Solid<fe::Hexahedron>;
using test::Held, test::zones;

Held<fe::Hexahedron> wedge(const material::Model& model, int elements = 40) {
  return {fe::sphere_wedge(fe::Wedge::sixteenth, elements), model};
}

/// Flattening, shear and random motion of the nodes.
std::vector<double> deformed(const Solid& solid, double noise) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> random(-noise, noise);
  std::vector<double> u;
  for (const auto& [x, y, z] : solid.mesh.nodes) {
    u.push_back(0.06 * x + 0.03 * x * z + random(generator));
    u.push_back(0.03 * y + 0.02 * x * y + random(generator));
    u.push_back(-0.1 * z + 0.02 * x * x + random(generator));
  }
  return u;
}

/// The tangent times a direction.
std::vector<double> along(const Held<fe::Hexahedron>& held, const std::vector<double>& d) {
  std::vector<double> product(d.size());
  for (int e = 0; e < held.solid.elements(); ++e) {
    const auto u = test::components<fe::Hexahedron>(held.solid.mesh.elements[e]);
    for (int j = 0; j < 24; ++j)
      for (int i = 0; i < 24; ++i) product[u[i]] += held.tangent[576 * e + 24 * j + i] * d[u[j]];
  }
  return product;
}

/// Largest error of some columns of the tangent against fourth-order differences of the forces, over their
/// largest entry; where a point changes its zone between them there is no derivative to compare with.
double tangent_error(Held<fe::Hexahedron>& held, const std::vector<double>& u, double h) {
  EXPECT_EQ(held.evaluate(u), fe::Evaluation::done);
  held.linearise();
  const auto zones_here = zones(held);
  double error = 0, scale = 0;
  int compared = 0;
  std::mt19937 generator(1);
  std::uniform_int_distribution<std::size_t> component(0, u.size() - 1);
  for (int direction = 0; direction < 40; ++direction) {
    std::vector<double> d(u.size()), slope(u.size());
    d[component(generator)] = 1;
    const auto exact = along(held, d);
    bool smooth = true;
    for (const auto& [step, weight] : {std::pair{-2.0, 1.0}, {-1.0, -8.0}, {1.0, 8.0}, {2.0, -1.0}}) {
      auto x = u;
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += step * h * d[i];
      EXPECT_EQ(held.evaluate(x), fe::Evaluation::done);
      for (std::size_t i = 0; i < x.size(); ++i) slope[i] += weight * held.response.force[i] / (12 * h);
      smooth = smooth && zones(held) == zones_here;
    }
    if (!smooth) continue;
    ++compared;
    for (std::size_t i = 0; i < u.size(); ++i) {
      error = std::max(error, std::abs(slope[i] - exact[i]));
      scale = std::max(scale, std::abs(exact[i]));
    }
  }
  EXPECT_GT(compared, 20);
  return error / scale;
}

} // namespace

TEST(SphereWedge, FillsItsShareOfTheSphere) {
  for (const fe::Wedge kind : {fe::Wedge::octant, fe::Wedge::sixteenth, fe::Wedge::forty_eighth})
    for (const int elements : {300, 1300, 6000}) {
      const fe::WedgeMesh mesh = fe::sphere_wedge(kind, elements);
      const Solid solid(mesh, material::Elastic{1, 0.3});
      const auto group = fe::copies(mesh);
      EXPECT_EQ(group.size(), kind == fe::Wedge::octant ? 8 : kind == fe::Wedge::sixteenth ? 16 : 48);
      EXPECT_NEAR(static_cast<double>(mesh.elements.size()), elements, 0.25 * elements);
      double volume = 0;
      for (int i = 0; i < solid.points(); ++i) volume += solid.volume(i) * static_cast<double>(group.size());
      EXPECT_NEAR(volume / (4 * std::numbers::pi / 3), 1, 1.4 / std::pow(elements, 2.0 / 3));
      for (int i = 0; i < solid.points(); ++i) EXPECT_GT(solid.volume(i), 0);
      const std::vector<double> still(3 * mesh.nodes.size(), 0.0);
      EXPECT_GT(fe::quality(mesh, still).least, 0.35);
      EXPECT_GT(fe::quality(mesh, still).mean, 0.8);
    }
}

TEST(SphereWedge, SurfaceIsOnTheSphereAndMirrorsOnTheirPlanes) {
  for (const fe::Wedge kind : {fe::Wedge::octant, fe::Wedge::sixteenth, fe::Wedge::forty_eighth}) {
    const fe::WedgeMesh mesh = fe::sphere_wedge(kind, 1300);
    double area = 0;
    for (const auto& face : mesh.surface) {
      fe::Vector3 x[4];
      for (int k = 0; k < 4; ++k) {
        x[k] = mesh.nodes[face[k]];
        EXPECT_NEAR(fe::norm(x[k]), 1, 1e-14);
      }
      const auto normal = fe::cross(x[2] - x[0], x[3] - x[1]);
      EXPECT_GT(fe::dot(normal, x[0]), 0);
      area += fe::norm(normal) / 2;
    }
    EXPECT_NEAR(area * static_cast<double>(fe::copies(mesh).size()) / (4 * std::numbers::pi), 1, 0.015);
    for (const auto& mirror : mesh.mirrors) {
      EXPECT_GT(mirror.nodes.size(), 20u);
      for (const int node : mirror.nodes) EXPECT_NEAR(fe::dot(mesh.nodes[node], mirror.normal), 0, 1e-16);
    }
    // Every face that only one element has lies on the sphere or on a mirror.
    std::vector<int> mirrored(mesh.nodes.size(), 0);
    for (const auto& mirror : mesh.mirrors)
      for (const int node : mirror.nodes) mirrored[node] = 1;
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
      if (!mirrored[i] && fe::norm(mesh.nodes[i]) < 1 - 1e-9) {
        int cells = 0;
        for (const auto& hex : mesh.elements)
          cells += std::count(hex.begin(), hex.end(), static_cast<int>(i));
        EXPECT_TRUE(cells == 8 || cells == 4 || cells == 6) << cells;
      }
  }
}

TEST(Hexahedron, ElasticTangentMatchesDifferencesAndIsSymmetric) {
  auto held = wedge(material::Elastic{1, 0.3});
  EXPECT_LT(tangent_error(held, deformed(held.solid, 1e-3), 1e-5), 1e-7);
  for (int e = 0; e < held.solid.elements(); ++e)
    for (int i = 0; i < 24; ++i)
      for (int j = 0; j < i; ++j)
        EXPECT_NEAR(held.tangent[576 * e + 24 * j + i], held.tangent[576 * e + 24 * i + j], 1e-12);
}

TEST(Hexahedron, PlasticTangentMatchesDifferences) {
  for (const material::Model& model :
       {material::Model(material::VonMises{100, 0.3, 1}),
        material::Model(material::VonMises{100, 0.3, 1, material::Ludwik{3, 0.35}}),
        material::Model(material::DruckerPrager{100, 0.2, 30, 1, 20}),
        material::Model(material::Vmdc{0.7, 1, 100, 0.3, 1, 0.1, 0.7, 10, 7.5, 10, 10, 0.4, 1.5})}) {
    auto held = wedge(model);
    // A plastic state first, then a further increment, so that C_p is no identity.
    auto u = deformed(held.solid, 1e-3);
    ASSERT_EQ(held.evaluate(u), fe::Evaluation::done);
    held.commit();
    for (double& x : u) x *= 1.15;
    EXPECT_LT(tangent_error(held, u, 1e-6), 1e-6) << model.index();
  }
}

TEST(Hexahedron, UniformDeformationIsExactInAnyFrame) {
  // Patch test: a stretch, turned by a rotation about (1, 1, 1).
  auto held = wedge(material::Elastic{1, 0.3});
  const fe::Vector3 stretch{1.1, 1.1, 0.8};
  constexpr int cyclic[3] = {1, 2, 0}; // x to y, y to z, z to x
  std::vector<double> u(3 * held.solid.mesh.nodes.size());
  for (std::size_t i = 0; i < held.solid.mesh.nodes.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      u[3 * i + cyclic[k]] += stretch[k] * held.solid.mesh.nodes[i][k];
      u[3 * i + k] -= held.solid.mesh.nodes[i][k];
    }
  ASSERT_EQ(held.evaluate(u), fe::Evaluation::done);
  const double e_r = std::log(1.1), e_z = std::log(0.8), v = 2 * e_r + e_z;
  const double K = 1 / (3 * 0.4), G = 1 / 2.6, J = 1.1 * 1.1 * 0.8;
  for (int i = 0; i < held.solid.points(); ++i) {
    const auto sigma = held.response.cauchy(i);
    EXPECT_NEAR(sigma[0], (K * v + 2 * G * (e_z - v / 3)) / J, 1e-12); // z went to x
    EXPECT_NEAR(sigma[1], (K * v + 2 * G * (e_r - v / 3)) / J, 1e-12);
    EXPECT_NEAR(sigma[2], (K * v + 2 * G * (e_r - v / 3)) / J, 1e-12);
    for (const int shear : {3, 4, 5}) EXPECT_NEAR(sigma[shear], 0, 1e-12);
  }
}

TEST(Hexahedron, ForcesAreTheDerivativeOfTheStoredEnergy) {
  auto held = wedge(material::Elastic{1, 0.3});
  const auto u = deformed(held.solid, 1e-3);
  const auto energy = [&](const std::vector<double>& x) {
    EXPECT_EQ(held.evaluate(x), fe::Evaluation::done);
    double sum = 0;
    for (int i = 0; i < held.solid.points(); ++i)
      sum += held.solid.volume(i) *
             material::stored_energy(held.solid.model, material::invariants(held.response.updates[i].eps), 0);
    return sum;
  };
  ASSERT_EQ(held.evaluate(u), fe::Evaluation::done);
  const auto force = held.response.force;
  for (std::size_t i = 0; i < u.size(); i += 7) {
    auto x = u, y = u;
    x[i] += 1e-6;
    y[i] -= 1e-6;
    EXPECT_NEAR((energy(x) - energy(y)) / 2e-6, force[i], 1e-8);
  }
}

TEST(Hexahedron, SaysWhenAnElementTurnsInsideOut) {
  auto held = wedge(material::Elastic{1, 0.3});
  std::vector<double> u(3 * held.solid.mesh.nodes.size());
  for (std::size_t i = 0; i < held.solid.mesh.nodes.size(); ++i)
    u[3 * i + 2] = -1.5 * held.solid.mesh.nodes[i][2];
  EXPECT_EQ(held.evaluate(u), fe::Evaluation::inverted_element);
}
