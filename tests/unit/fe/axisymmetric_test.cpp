// The axisymmetric solid: its tangent, its patch test, its energy.

#include "fe/axisymmetric.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using namespace platen;

namespace {

/// The tangent, summed from its element matrices; by rows.
std::vector<double> dense_tangent(fe::AxisymmetricSolid& solid, double added = 0) {
  solid.linearise(added);
  const int n = solid.unknowns();
  std::vector<double> K(n * n);
  for (int e = 0; e < static_cast<int>(solid.mesh.quads.size()); ++e) {
    const auto u = solid.unknowns_of(e);
    for (int i = 0; i < 8; ++i)
      for (int j = 0; j < 8; ++j) K[u[i] * n + u[j]] += solid.tangent[64 * e + 8 * j + i];
  }
  return K;
}

std::vector<material::Zone> zones(const fe::AxisymmetricSolid& solid) {
  std::vector<material::Zone> list;
  for (const auto& point : solid.updates) list.push_back(point.zone);
  return list;
}

/// Largest error of the tangent against fourth-order differences of the forces, over its largest entry; where
/// a point changes its zone between them there is no derivative to compare with.
double tangent_error(fe::AxisymmetricSolid& solid, std::vector<double> u, double h) {
  EXPECT_EQ(solid.evaluate(u), fe::Evaluation::done);
  const int n = solid.unknowns();
  const std::vector<double> exact = dense_tangent(solid);
  double scale = 0, error = 0;
  for (const double entry : exact) scale = std::max(scale, std::abs(entry));
  const auto zones_here = zones(solid);
  int compared = 0;
  for (int j = 0; j < n; ++j) {
    bool smooth = true;
    std::vector<double> slope(n);
    for (const auto& [step, weight] : {std::pair{-2.0, 1.0}, {-1.0, -8.0}, {1.0, 8.0}, {2.0, -1.0}}) {
      auto x = u;
      x[j] += step * h;
      EXPECT_EQ(solid.evaluate(x), fe::Evaluation::done);
      for (int i = 0; i < n; ++i) slope[i] += weight * solid.force[i] / (12 * h);
      smooth = smooth && zones(solid) == zones_here;
    }
    if (!smooth) continue;
    ++compared;
    for (int i = 0; i < n; ++i) error = std::max(error, std::abs(slope[i] - exact[i * n + j]));
  }
  EXPECT_GT(compared, n / 2);
  return error / scale;
}

std::vector<double> deformed(const fe::AxisymmetricSolid& solid, double noise) {
  // Flattening, shear and random motion of the nodes; the axis stays the axis.
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> random(-noise, noise);
  std::vector<double> u(solid.unknowns());
  for (std::size_t i = 0; i < solid.mesh.nodes.size(); ++i) {
    const auto [r, z] = solid.mesh.nodes[i];
    u[2 * i] = r == 0 ? 0 : 0.06 * r + 0.03 * r * z + random(generator);
    u[2 * i + 1] = -0.1 * z + 0.02 * r * r + random(generator);
  }
  return u;
}

} // namespace

TEST(AxisymmetricSolid, MeshFillsTheHalfSphere) {
  for (const int elements : {100, 1000, 5000}) {
    const fe::AxisymmetricSolid solid(fe::quarter_disc(elements), material::Elastic{1, 0.3});
    double volume = 0;
    for (const double v : solid.volume) volume += v;
    EXPECT_NEAR(static_cast<double>(solid.mesh.quads.size()), elements, 0.15 * elements);
    EXPECT_NEAR(volume, 2 * std::numbers::pi / 3, 0.02 * 100 / elements);
    for (const double v : solid.volume) EXPECT_GT(v, 0);
  }
}

TEST(AxisymmetricSolid, ElasticTangentMatchesDifferences) {
  fe::AxisymmetricSolid solid(fe::quarter_disc(40), material::Elastic{1, 0.3});
  EXPECT_LT(tangent_error(solid, deformed(solid, 1e-3), 1e-4), 1e-6);
}

TEST(AxisymmetricSolid, ElasticTangentIsSymmetric) {
  fe::AxisymmetricSolid solid(fe::quarter_disc(40), material::Elastic{1, 0.3});
  ASSERT_EQ(solid.evaluate(deformed(solid, 1e-3)), fe::Evaluation::done);
  const auto K = dense_tangent(solid);
  const int n = solid.unknowns();
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < i; ++j) EXPECT_NEAR(K[i * n + j], K[j * n + i], 1e-12);
}

TEST(AxisymmetricSolid, PlasticTangentMatchesDifferences) {
  for (const material::Model& model :
       {material::Model(material::VonMises{100, 0.3, 1}),
        material::Model(material::VonMises{100, 0.3, 1, material::Ludwik{3, 0.35}}),
        material::Model(material::DruckerPrager{100, 0.2, 30, 1, 20}),
        material::Model(material::Vmdc{0.7, 1, 100, 0.3, 1, 0.1, 0.7, 10, 7.5, 10, 10, 0.4, 1.5})}) {
    fe::AxisymmetricSolid solid(fe::quarter_disc(40), model);
    // A plastic state first, then a further increment, so that C_p is no identity.
    auto u = deformed(solid, 1e-3);
    ASSERT_EQ(solid.evaluate(u), fe::Evaluation::done);
    solid.commit();
    for (std::size_t i = 0; i < u.size(); ++i) u[i] *= 1.15;
    EXPECT_LT(tangent_error(solid, u, 2e-6), 1e-6) << model.index();
  }
}

TEST(AxisymmetricSolid, AddedStiffnessIsOfShearWhereMaterialFlows) {
  fe::AxisymmetricSolid solid(fe::quarter_disc(40), material::VonMises{100, 0.3, 1});
  const auto work_of_addition = [&](const std::vector<double>& v) {
    const auto K = dense_tangent(solid), stiffer = dense_tangent(solid, 0.3);
    double sum = 0;
    for (std::size_t i = 0; i < v.size(); ++i)
      for (std::size_t j = 0; j < v.size(); ++j)
        sum += v[i] * (stiffer[i * v.size() + j] - K[i * v.size() + j]) * v[j];
    return sum;
  };
  const auto u = deformed(solid, 1e-3);
  auto little = u;
  for (double& x : little) x *= 1e-3;
  ASSERT_EQ(solid.evaluate(little), fe::Evaluation::done);
  EXPECT_EQ(work_of_addition(u), 0) << "nothing flows";
  ASSERT_EQ(solid.evaluate(u), fe::Evaluation::done);
  const auto flowing = zones(solid);
  ASSERT_NE(std::count(flowing.begin(), flowing.end(), material::Zone::shear), 0);
  const double of_shear = work_of_addition(u);
  EXPECT_GT(of_shear, 0);
  std::vector<double> dilatation; // of the deformed shape, as large
  for (std::size_t i = 0; i < solid.mesh.nodes.size(); ++i)
    for (int k = 0; k < 2; ++k) dilatation.push_back(1e-3 * (solid.mesh.nodes[i][k] + u[2 * i + k]));
  EXPECT_NEAR(work_of_addition(dilatation), 0, 1e-9 * of_shear);
}

TEST(AxisymmetricSolid, UniformStretchIsExact) {
  // Patch test: u_r = a r, u_z = b z gives the same stress at every point.
  fe::AxisymmetricSolid solid(fe::quarter_disc(100), material::Elastic{1, 0.3});
  std::vector<double> u(solid.unknowns());
  for (std::size_t i = 0; i < solid.mesh.nodes.size(); ++i) {
    u[2 * i] = 0.1 * solid.mesh.nodes[i][0];
    u[2 * i + 1] = -0.2 * solid.mesh.nodes[i][1];
  }
  ASSERT_EQ(solid.evaluate(u), fe::Evaluation::done);
  const double e_r = std::log(1.1), e_z = std::log(0.8), v = 2 * e_r + e_z;
  const double K = 1 / (3 * 0.4), G = 1 / 2.6, J = 1.1 * 1.1 * 0.8;
  for (int i = 0; i < solid.points(); ++i) {
    const auto sigma = solid.cauchy(i);
    EXPECT_NEAR(sigma[1], (K * v + 2 * G * (e_z - v / 3)) / J, 1e-12);
    EXPECT_NEAR(sigma[0], (K * v + 2 * G * (e_r - v / 3)) / J, 1e-12);
    EXPECT_NEAR(sigma[2], 0, 1e-12);
  }
}

TEST(AxisymmetricSolid, ForcesAreTheDerivativeOfTheStoredEnergy) {
  fe::AxisymmetricSolid solid(fe::quarter_disc(40), material::Elastic{1, 0.3});
  const auto u = deformed(solid, 1e-3);
  const auto energy = [&](const std::vector<double>& x) {
    EXPECT_EQ(solid.evaluate(x), fe::Evaluation::done);
    double sum = 0;
    for (int i = 0; i < solid.points(); ++i)
      sum += solid.volume[i] *
             material::stored_energy(solid.model, material::invariants(solid.updates[i].eps), 0);
    return sum;
  };
  ASSERT_EQ(solid.evaluate(u), fe::Evaluation::done);
  const auto force = solid.force;
  for (int i = 0; i < solid.unknowns(); i += 5) {
    auto x = u, y = u;
    x[i] += 1e-6;
    y[i] -= 1e-6;
    EXPECT_NEAR((energy(x) - energy(y)) / 2e-6, force[i], 1e-8);
  }
}

TEST(AxisymmetricSolid, SaysWhenAnElementTurnsInsideOut) {
  fe::AxisymmetricSolid solid(fe::quarter_disc(40), material::Elastic{1, 0.3});
  std::vector<double> u(solid.unknowns());
  for (std::size_t i = 0; i < solid.mesh.nodes.size(); ++i) u[2 * i + 1] = -1.5 * solid.mesh.nodes[i][1];
  EXPECT_EQ(solid.evaluate(u), fe::Evaluation::inverted_element);
}
