// The solid of revolution: its tangent, its patch test, its energy.

#include "fe/quad.hpp"
#include "fe/quarter_disc.hpp"
#include "solids.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using namespace platen;

namespace {

using Solid = fe::Solid<fe::Quad>;
using test::Held, test::zones;

/// The tangent, summed from its element matrices; by rows.
std::vector<double> dense_tangent(Held<fe::Quad>& held, double added = 0) {
  held.linearise(added);
  const int n = held.solid.components();
  std::vector<double> K(n * n);
  for (int e = 0; e < held.solid.elements(); ++e) {
    const auto u = test::components<fe::Quad>(held.solid.mesh.elements[e]);
    for (int i = 0; i < 8; ++i)
      for (int j = 0; j < 8; ++j) K[u[i] * n + u[j]] += held.tangent[64 * e + 8 * j + i];
  }
  return K;
}

/// Largest error of the tangent against fourth-order differences of the forces, over its largest entry; where
/// a point changes its zone between them there is no derivative to compare with.
double tangent_error(Held<fe::Quad>& held, std::vector<double> u, double h) {
  EXPECT_EQ(held.evaluate(u), fe::Evaluation::done);
  const int n = held.solid.components();
  const std::vector<double> exact = dense_tangent(held);
  double scale = 0, error = 0;
  for (const double entry : exact) scale = std::max(scale, std::abs(entry));
  const auto zones_here = zones(held);
  int compared = 0;
  for (int j = 0; j < n; ++j) {
    bool smooth = true;
    std::vector<double> slope(n);
    for (const auto& [step, weight] : {std::pair{-2.0, 1.0}, {-1.0, -8.0}, {1.0, 8.0}, {2.0, -1.0}}) {
      auto x = u;
      x[j] += step * h;
      EXPECT_EQ(held.evaluate(x), fe::Evaluation::done);
      for (int i = 0; i < n; ++i) slope[i] += weight * held.response.force[i] / (12 * h);
      smooth = smooth && zones(held) == zones_here;
    }
    if (!smooth) continue;
    ++compared;
    for (int i = 0; i < n; ++i) error = std::max(error, std::abs(slope[i] - exact[i * n + j]));
  }
  EXPECT_GT(compared, n / 2);
  return error / scale;
}

std::vector<double> deformed(const Solid& solid, double noise) {
  // Flattening, shear and random motion of the nodes; the axis stays the axis.
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> random(-noise, noise);
  std::vector<double> u(solid.components());
  for (std::size_t i = 0; i < solid.mesh.nodes.size(); ++i) {
    const auto [r, z] = solid.mesh.nodes[i];
    u[2 * i] = r == 0 ? 0 : 0.06 * r + 0.03 * r * z + random(generator);
    u[2 * i + 1] = -0.1 * z + 0.02 * r * r + random(generator);
  }
  return u;
}

} // namespace

TEST(Quad, MeshFillsTheHalfSphere) {
  for (const int elements : {100, 1000, 5000}) {
    const Solid solid(fe::quarter_disc(elements), material::Elastic{1, 0.3});
    double volume = 0;
    for (int i = 0; i < solid.points(); ++i) volume += solid.volume(i);
    EXPECT_NEAR(solid.elements(), elements, 0.15 * elements);
    EXPECT_NEAR(volume, 2 * std::numbers::pi / 3, 0.02 * 100 / elements);
    for (int i = 0; i < solid.points(); ++i) EXPECT_GT(solid.volume(i), 0);
  }
}

TEST(Quad, ElasticTangentMatchesDifferences) {
  Held<fe::Quad> held(fe::quarter_disc(40), material::Elastic{1, 0.3});
  EXPECT_LT(tangent_error(held, deformed(held.solid, 1e-3), 1e-4), 1e-6);
}

TEST(Quad, ElasticTangentIsSymmetric) {
  Held<fe::Quad> held(fe::quarter_disc(40), material::Elastic{1, 0.3});
  ASSERT_EQ(held.evaluate(deformed(held.solid, 1e-3)), fe::Evaluation::done);
  const auto K = dense_tangent(held);
  const int n = held.solid.components();
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < i; ++j) EXPECT_NEAR(K[i * n + j], K[j * n + i], 1e-12);
}

TEST(Quad, PlasticTangentMatchesDifferences) {
  for (const material::Model& model :
       {material::Model(material::VonMises{100, 0.3, 1}),
        material::Model(material::VonMises{100, 0.3, 1, material::Ludwik{3, 0.35}}),
        material::Model(material::DruckerPrager{100, 0.2, 30, 1, 20}),
        material::Model(material::Vmdc{0.7, 1, 100, 0.3, 1, 0.1, 0.7, 10, 7.5, 10, 10, 0.4, 1.5})}) {
    Held<fe::Quad> held(fe::quarter_disc(40), model);
    // A plastic state first, then a further increment, so that C_p is no identity.
    auto u = deformed(held.solid, 1e-3);
    ASSERT_EQ(held.evaluate(u), fe::Evaluation::done);
    held.commit();
    for (std::size_t i = 0; i < u.size(); ++i) u[i] *= 1.15;
    EXPECT_LT(tangent_error(held, u, 2e-6), 1e-6) << model.index();
  }
}

TEST(Quad, AddedStiffnessIsOfShearWhereMaterialFlows) {
  Held<fe::Quad> held(fe::quarter_disc(40), material::VonMises{100, 0.3, 1});
  const auto work_of_addition = [&](const std::vector<double>& v) {
    const auto K = dense_tangent(held), stiffer = dense_tangent(held, 0.3);
    double sum = 0;
    for (std::size_t i = 0; i < v.size(); ++i)
      for (std::size_t j = 0; j < v.size(); ++j)
        sum += v[i] * (stiffer[i * v.size() + j] - K[i * v.size() + j]) * v[j];
    return sum;
  };
  const auto u = deformed(held.solid, 1e-3);
  auto little = u;
  for (double& x : little) x *= 1e-3;
  ASSERT_EQ(held.evaluate(little), fe::Evaluation::done);
  EXPECT_EQ(work_of_addition(u), 0) << "nothing flows";
  ASSERT_EQ(held.evaluate(u), fe::Evaluation::done);
  const auto flowing = zones(held);
  ASSERT_NE(std::count(flowing.begin(), flowing.end(), material::Zone::shear), 0);
  const double of_shear = work_of_addition(u);
  EXPECT_GT(of_shear, 0);
  std::vector<double> dilatation; // of the deformed shape, as large
  for (std::size_t i = 0; i < held.solid.mesh.nodes.size(); ++i)
    for (int k = 0; k < 2; ++k) dilatation.push_back(1e-3 * (held.solid.mesh.nodes[i][k] + u[2 * i + k]));
  EXPECT_NEAR(work_of_addition(dilatation), 0, 1e-9 * of_shear);
}

TEST(Quad, UniformStretchIsExact) {
  // Patch test: u_r = a r, u_z = b z gives the same stress at every point.
  Held<fe::Quad> held(fe::quarter_disc(100), material::Elastic{1, 0.3});
  std::vector<double> u(held.solid.components());
  for (std::size_t i = 0; i < held.solid.mesh.nodes.size(); ++i) {
    u[2 * i] = 0.1 * held.solid.mesh.nodes[i][0];
    u[2 * i + 1] = -0.2 * held.solid.mesh.nodes[i][1];
  }
  ASSERT_EQ(held.evaluate(u), fe::Evaluation::done);
  const double e_r = std::log(1.1), e_z = std::log(0.8), v = 2 * e_r + e_z;
  const double K = 1 / (3 * 0.4), G = 1 / 2.6, J = 1.1 * 1.1 * 0.8;
  for (int i = 0; i < held.solid.points(); ++i) {
    const auto sigma = held.response.cauchy(i);
    EXPECT_NEAR(sigma[1], (K * v + 2 * G * (e_z - v / 3)) / J, 1e-12);
    EXPECT_NEAR(sigma[0], (K * v + 2 * G * (e_r - v / 3)) / J, 1e-12);
    EXPECT_NEAR(sigma[2], 0, 1e-12);
  }
}

TEST(Quad, ForcesAreTheDerivativeOfTheStoredEnergy) {
  Held<fe::Quad> held(fe::quarter_disc(40), material::Elastic{1, 0.3});
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
  for (int i = 0; i < held.solid.components(); i += 5) {
    auto x = u, y = u;
    x[i] += 1e-6;
    y[i] -= 1e-6;
    EXPECT_NEAR((energy(x) - energy(y)) / 2e-6, force[i], 1e-8);
  }
}

TEST(Quad, SaysWhenAnElementTurnsInsideOut) {
  Held<fe::Quad> held(fe::quarter_disc(40), material::Elastic{1, 0.3});
  std::vector<double> u(held.solid.components());
  for (std::size_t i = 0; i < held.solid.mesh.nodes.size(); ++i)
    u[2 * i + 1] = -1.5 * held.solid.mesh.nodes[i][1];
  EXPECT_EQ(held.evaluate(u), fe::Evaluation::inverted_element);
}
