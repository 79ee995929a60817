#include "fe/contact.hpp"

#include "fe/quarter_disc.hpp"
#include "fe/sphere_wedge.hpp"
#include "systems.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace platen;
using fe::Contact, fe::ContactMemory, fe::ContactRule;

namespace {

const material::Model elastic = material::Elastic{1, 0.3};
const std::vector<ContactRule> rules{
    {}, {.uniform = true}, {.flat_faces = true}, {.uniform = true, .flat_faces = true}};

/// A contact, where its planes lie, and a displacement under which they touch.
template <class Mesh> struct Pressed {
  Mesh mesh;
  std::vector<fe::Vector<Mesh::dim>> normals;
  std::vector<int> copies;
  std::vector<double> heights;
  Contact<Mesh> contact;
  std::vector<double> u;
  ContactMemory memory{0.01, 0.2};

  Pressed(Mesh mesh_, std::vector<fe::Vector<Mesh::dim>> normals_, std::vector<int> copies_,
          std::vector<double> heights_, const ContactRule& rule)
      : mesh(std::move(mesh_)), normals(std::move(normals_)), copies(std::move(copies_)),
        heights(std::move(heights_)), contact(mesh, normals, copies, rule, elastic),
        u(test::random_vector(Mesh::dim * mesh.nodes.size(), 3)) {
    for (double& x : u) x *= 0.003;
  }

  std::vector<double> forces(const std::vector<double>& at, std::vector<char>* touching = nullptr) const {
    std::vector<double> force(at.size());
    std::vector<char> ignored;
    contact.add_forces(at, heights, memory, force, touching ? *touching : ignored);
    return force;
  }
  /// Of the mesh alone.
  double energy(const std::vector<double>& at) const {
    double sum = 0;
    for (int k = 0; k < contact.planes(); ++k)
      for (const auto& face : contact.pressures(k, at, heights[k], memory)) sum += face.energy;
    return sum;
  }
};

Pressed<fe::SectionMesh> section(const ContactRule& rule) {
  return {fe::quarter_disc(100), {{0, 1}}, {1}, {0.95}, rule};
}
Pressed<fe::WedgeMesh> wedge(const ContactRule& rule) {
  return {fe::sphere_wedge(fe::Wedge::sixteenth, 200), {{0, 0, 1}, {1, 0, 0}}, {8, 4}, {0.95, 0.97}, rule};
}

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double v : values) most = std::max(most, std::abs(v));
  return most;
}

template <class Mesh> void expect_forces_of_the_energy(const Pressed<Mesh>& p) {
  constexpr double h = 1e-7;
  const auto force = p.forces(p.u);
  ASSERT_GT(largest(force), 0);
  for (std::size_t i = 0; i < p.u.size(); ++i) {
    if (force[i] == 0) continue;
    auto x = p.u, y = p.u;
    x[i] += h;
    y[i] -= h;
    EXPECT_NEAR((p.energy(x) - p.energy(y)) / (2 * h), force[i], 1e-5 * largest(force)) << i;
  }
}

template <class Mesh> void expect_tangent_of_the_forces(const Pressed<Mesh>& p) {
  constexpr int size = Mesh::dim * Mesh::corners;
  constexpr double h = 1e-6;
  std::vector<char> touching;
  (void)p.forces(p.u, &touching);
  std::vector<double> matrices(static_cast<std::size_t>(size * size) * p.mesh.elements.size());
  p.contact.add_tangent(touching, p.memory, matrices);
  int compared = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    auto d = test::random_vector(p.u.size(), seed), x = p.u, y = p.u;
    // Along most directions some point begins to touch or ceases to; along those of single nodes fewer do.
    for (std::size_t i = 0; i < d.size(); ++i)
      if (i / Mesh::dim % 20 != seed - 1) d[i] = 0;
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += h * d[i], y[i] -= h * d[i];
    std::vector<char> there, back;
    const auto ahead = p.forces(x, &there), behind = p.forces(y, &back);
    if (there != touching || back != touching) continue;
    ++compared;
    std::vector<double> exact(d.size());
    for (std::size_t e = 0; e < p.mesh.elements.size(); ++e) {
      const auto component = [&](int k) {
        return Mesh::dim * p.mesh.elements[e][k / Mesh::dim] + k % Mesh::dim;
      };
      for (int j = 0; j < size; ++j)
        for (int i = 0; i < size; ++i)
          exact[component(i)] += matrices[size * size * e + size * j + i] * d[component(j)];
    }
    for (std::size_t i = 0; i < d.size(); ++i)
      EXPECT_NEAR((ahead[i] - behind[i]) / (2 * h), exact[i], 1e-7 * std::max(largest(exact), 1e-3));
  }
  EXPECT_GT(compared, 5);
}

template <class Mesh> void expect_nothing_without_touch(Pressed<Mesh> p) {
  // Flat faces of so coarse a mesh stand out of the sphere by up to 0.003.
  constexpr double height = 1.005;
  const std::vector<double> still(p.u.size());
  std::fill(p.heights.begin(), p.heights.end(), height);
  std::vector<char> touching;
  EXPECT_EQ(largest(p.forces(still, &touching)), 0);
  EXPECT_EQ(std::count(touching.begin(), touching.end(), 1), 0);
  for (int k = 0; k < p.contact.planes(); ++k) {
    const auto patch = p.contact.patch(k, still, height, p.memory);
    EXPECT_EQ(patch.force, 0);
    EXPECT_EQ(patch.radius, 0);
    EXPECT_EQ(patch.energy, 0);
    EXPECT_TRUE(p.contact.pressures(k, still, height, p.memory).empty());
    EXPECT_TRUE(p.contact.nodes_touching(k, still, height).empty());
  }
}

template <class Mesh> void expect_pure(const Pressed<Mesh>& p) {
  std::vector<char> touching, again;
  const auto force = p.forces(p.u, &touching);
  const auto patch = p.contact.patch(0, p.u, p.heights[0], p.memory);
  const std::vector<double> other(p.u.size(), -0.01);
  (void)p.forces(other);
  (void)p.contact.extended(p.memory, std::vector{patch}, p.heights);
  EXPECT_EQ(p.forces(p.u, &again), force);
  EXPECT_EQ(again, touching);
  EXPECT_EQ(p.contact.patch(0, p.u, p.heights[0], p.memory).force, patch.force);
}

/// The resultant on each plane is what its patch says.
template <class Mesh> void expect_patch_of_the_forces(const Pressed<Mesh>& p) {
  const auto force = p.forces(p.u);
  for (int k = 0; k < p.contact.planes(); ++k) {
    double sum = 0;
    for (std::size_t i = 0; i < force.size(); ++i) sum += force[i] * p.normals[k][i % Mesh::dim];
    const auto patch = p.contact.patch(k, p.u, p.heights[k], p.memory);
    EXPECT_NEAR(patch.force / p.copies[k] / sum, 1, 1e-12);
    EXPECT_GE(patch.peak_pressure, patch.force / (std::numbers::pi * patch.radius * patch.radius));
  }
}

} // namespace

TEST(Contact, ForcesAreTheDerivativeOfTheEnergy) {
  for (const auto& rule : rules) {
    expect_forces_of_the_energy(section(rule));
    expect_forces_of_the_energy(wedge(rule));
  }
}

TEST(Contact, TangentIsTheDerivativeOfTheForces) {
  for (const auto& rule : rules) {
    expect_tangent_of_the_forces(section(rule));
    expect_tangent_of_the_forces(wedge(rule));
  }
}

TEST(Contact, PatchCarriesTheForcesOnTheNodes) {
  for (const auto& rule : rules) {
    expect_patch_of_the_forces(section(rule));
    expect_patch_of_the_forces(wedge(rule));
  }
}

TEST(Contact, IsNothingWithoutTouch) {
  for (const auto& rule : rules) {
    expect_nothing_without_touch(section(rule));
    expect_nothing_without_touch(wedge(rule));
  }
}

TEST(Contact, AnswersTheSameQuestionTheSame) {
  for (const auto& rule : rules) {
    expect_pure(section(rule));
    expect_pure(wedge(rule));
  }
}

TEST(Contact, BeginsWithHertzsPressureAndRemembersTheHighest) {
  const auto p = section({});
  const ContactMemory first = p.contact.memory();
  // p_m = 4 E*/(3 pi) a/R, at a = 0.03 R
  EXPECT_NEAR(first.pressure_scale, 4 / (3 * std::numbers::pi) / (1 - 0.09) * 0.03, 1e-15);
  const fe::ContactPatch patch{.force = 0.1, .radius = 0.2};
  const auto more = p.contact.extended(first, std::vector{patch}, p.heights);
  EXPECT_NEAR(more.pressure_scale, 0.1 / (std::numbers::pi * 0.04), 1e-15);
  EXPECT_EQ(more.largest_radius, 0.2);
  const auto less =
      p.contact.extended(more, std::vector{fe::ContactPatch{.force = 0.01, .radius = 0.1}}, p.heights);
  EXPECT_EQ(less.pressure_scale, more.pressure_scale);
  EXPECT_EQ(less.largest_radius, more.largest_radius);
}

TEST(Contact, TouchesWhereTheSphereReachesThePlane) {
  // Undeformed, the points within sqrt(2 delta - delta^2) of the pole.
  const auto p = section({});
  const std::vector<double> still(p.u.size());
  constexpr double delta = 0.05;
  const double r = std::sqrt(2 * delta - delta * delta);
  const auto rings = p.contact.pressures(0, still, 1 - delta, p.memory);
  ASSERT_FALSE(rings.empty());
  for (std::size_t i = 1; i < rings.size(); ++i) EXPECT_EQ(rings[i].inner, rings[i - 1].outer);
  EXPECT_EQ(rings.front().inner, 0);
  EXPECT_LT(rings.back().inner, r);
  EXPECT_GT(rings.back().outer, r);
  EXPECT_LT(rings.back().reach, r);
  for (const int node : p.contact.nodes_touching(0, still, 1 - delta))
    EXPECT_LE(p.mesh.nodes[node][0], rings.back().outer);
}

TEST(Contact, FlatFacesCarryWhatTheSphereOverThemDoes) {
  // Where all of a face penetrates and its stiffness is even, its force is that of the mean distance.
  const auto flat = wedge({.uniform = true, .flat_faces = true}), round = wedge({.uniform = true});
  const std::vector<double> still(flat.u.size());
  const auto on = flat.contact.pressures(0, still, 0.9, flat.memory),
             under = round.contact.pressures(0, still, 0.9, round.memory);
  int compared = 0;
  for (const auto& a : on)
    for (const auto& b : under)
      if (a.face == b.face && a.touching == 1 && b.touching == 1) {
        EXPECT_NEAR(a.pressure / b.pressure, 1, 1e-12);
        ++compared;
      }
  EXPECT_GT(compared, 2);
}

TEST(Contact, FlatFacesAreNoStifferThanLetsThemTakeTheSpheresPlace) {
  // At the pressure scale they penetrate by at least the mean height of the sphere over them.
  const auto p = wedge({.flat_faces = true});
  const std::vector<double> still(p.u.size());
  const fe::Surface<fe::WedgeMesh> surface(p.mesh);
  const auto depth = [](const fe::Vector3& X) { return 1 - X[2]; };
  int compared = 0;
  for (const auto& f : p.contact.pressures(0, still, 0.9, p.memory)) {
    if (f.touching < 1) continue;
    double area = 0, sphere = 0, face = 0;
    for (const auto& point : surface.faces[f.face].point) {
      area += point.area;
      sphere += point.area * depth(point.X);
      for (int a = 0; a < 4; ++a)
        face += point.area * point.N[a] * depth(p.mesh.nodes[p.mesh.surface[f.face][a]]);
    }
    const double misfit = (face - sphere) / area, penetration = 0.1 - sphere / area;
    EXPECT_GT(misfit, 0);
    EXPECT_LE(f.pressure * f.area / area, p.memory.pressure_scale * penetration / misfit * (1 + 1e-9));
    ++compared;
  }
  EXPECT_GT(compared, 2);
}
