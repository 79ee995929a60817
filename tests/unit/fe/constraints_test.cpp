#include "fe/constraints.hpp"

#include "fe/quarter_disc.hpp"
#include "fe/sphere_wedge.hpp"
#include "systems.hpp"

#include <gtest/gtest.h>

#include <numeric>

using namespace platen;
using fe::Constraints;
using fe::operator-, fe::operator*;
using test::random_vector;

namespace {

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// What the unknowns are, as columns.
template <class Mesh> std::vector<std::vector<double>> columns(const Constraints<Mesh>& constraints) {
  std::vector<std::vector<double>> C;
  std::vector<double> x(constraints.unknowns());
  for (double& one : x) {
    one = 1;
    constraints.expand(x, C.emplace_back());
    one = 0;
  }
  return C;
}

template <class Mesh> void expect_adjoint(const Mesh& mesh) {
  const Constraints<Mesh> constraints(mesh);
  const auto x = random_vector(constraints.unknowns(), 1),
             force = random_vector(Mesh::dim * mesh.nodes.size(), 2);
  std::vector<double> u, on_unknowns;
  constraints.expand(x, u);
  constraints.reduce(force, on_unknowns);
  ASSERT_EQ(u.size(), force.size());
  EXPECT_NEAR(dot(u, force), dot(x, on_unknowns), 1e-12);
  EXPECT_NEAR(dot(u, u), dot(x, x), 1e-11) << "directions of a node are orthonormal";
}

template <class Mesh> void expect_reduced_is_CtKC(const Mesh& mesh) {
  constexpr int size = Mesh::dim * Mesh::corners;
  const Constraints<Mesh> constraints(mesh);
  const auto C = columns(constraints);
  const std::size_t n = C.size(), components = Mesh::dim * mesh.nodes.size();
  const auto matrices = random_vector(static_cast<std::size_t>(size * size) * mesh.elements.size(), 3);
  std::vector<double> K(components * components), reduced(constraints.entries()), sum(n * n);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto component = [&](int k) {
      return static_cast<std::size_t>(Mesh::dim * mesh.elements[e][k / Mesh::dim] + k % Mesh::dim);
    };
    for (int j = 0; j < size; ++j)
      for (int i = 0; i < size; ++i)
        K[components * component(i) + component(j)] += matrices[size * size * e + size * j + i];
  }
  constraints.reduce_matrices(matrices, reduced);
  const double* entry = reduced.data();
  for (const auto& list : constraints.element_unknowns())
    for (const int column : list)
      for (const int row : list) sum[n * row + column] += *entry++;
  EXPECT_EQ(entry, reduced.data() + reduced.size());
  for (std::size_t j = 0; j < n; ++j) {
    const auto KC = test::times(K, C[j]);
    for (std::size_t i = 0; i < n; ++i) ASSERT_NEAR(sum[n * i + j], dot(C[i], KC), 1e-12) << i << ' ' << j;
  }
}

} // namespace

TEST(Constraints, ReduceIsTheAdjointOfExpand) {
  expect_adjoint(fe::quarter_disc(100));
  for (const auto kind : {fe::Wedge::octant, fe::Wedge::sixteenth, fe::Wedge::forty_eighth})
    expect_adjoint(fe::sphere_wedge(kind, 200));
}

TEST(Constraints, ReduceElementMatricesToThoseOfTheUnknowns) {
  expect_reduced_is_CtKC(fe::quarter_disc(40));
  expect_reduced_is_CtKC(fe::sphere_wedge(fe::Wedge::forty_eighth, 20));
}

TEST(Constraints, KeepNodesOnObliqueMirrors) {
  // Between x = 0, x = y and y = z the centre stays, nodes where two mirrors meet move along their line, and
  // nodes of one mirror in it.
  const auto mesh = fe::sphere_wedge(fe::Wedge::forty_eighth, 200);
  const Constraints<fe::WedgeMesh> constraints(mesh);
  std::vector<double> u;
  constraints.expand(random_vector(constraints.unknowns(), 1), u);
  std::vector<int> mirrors(mesh.nodes.size(), 0);
  for (const auto& mirror : mesh.mirrors)
    for (const int node : mirror.nodes) {
      ++mirrors[node];
      const fe::Vector3 moved{u[3 * node], u[3 * node + 1], u[3 * node + 2]};
      EXPECT_NEAR(fe::dot(mirror.normal, moved), 0, 1e-15);
    }
  int free = 0;
  for (const int count : mirrors) free += 3 - count;
  EXPECT_EQ(constraints.unknowns(), free);
}

TEST(Constraints, MoveANodeAsFarAsItsMirrorsLetIt) {
  const auto mesh = fe::sphere_wedge(fe::Wedge::forty_eighth, 200);
  const Constraints<fe::WedgeMesh> constraints(mesh);
  const fe::Vector3 by{0.3, -0.2, 0.5};
  std::vector<int> mirror_of(mesh.nodes.size(), -1);
  for (std::size_t m = 0; m < mesh.mirrors.size(); ++m)
    for (const int node : mesh.mirrors[m].nodes)
      mirror_of[node] = mirror_of[node] == -1 ? static_cast<int>(m) : -2; // -2: of several
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
    if (mirror_of[node] == -2) continue;
    fe::Vector3 wanted = by;
    if (mirror_of[node] >= 0) {
      const auto& normal = mesh.mirrors[mirror_of[node]].normal;
      wanted = by - fe::dot(by, normal) * normal;
    }
    std::vector<double> x(constraints.unknowns()), u;
    constraints.move(static_cast<int>(node), by, x);
    constraints.expand(x, u);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(u[3 * node + k], wanted[k], 1e-15);
  }
}
