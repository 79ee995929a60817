// The return in principal stresses, of Mohr-Coulomb and of Drucker-Prager where its section is no circle: on
// the surface, its corners and its apex included, consistent, dissipative.

#include "random_states.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <variant>

using namespace platen::material;
using namespace platen::material::testing;

namespace {

std::array<double, 3> random_strain(std::mt19937& generator, double E, double size) {
  std::uniform_real_distribution<double> sign(-1, 1), unit(0, 1);
  const double start = 10 / E, increment = size * std::pow(10, -3 * unit(generator));
  std::array<double, 3> eps;
  for (double& e : eps) e = start * sign(generator) - start * unit(generator) + increment * sign(generator);
  if (unit(generator) < 0.2) eps[1] = eps[2]; // onto the edges
  if (unit(generator) < 0.2) eps[0] = eps[1];
  return eps;
}

std::vector<Model> materials() {
  std::vector<Model> all;
  for (const auto& m : rocks_by_mohr()) all.emplace_back(m);
  for (const double K : {7.0 / 9, 0.778, 0.9})
    for (DruckerPrager m : rocks()) {
      m.flow_stress_ratio = K;
      all.emplace_back(m);
    }
  return all;
}

double excess(const Model& model, const std::array<double, 3>& sigma) {
  return std::visit(
      [&]<class M>(const M& m) -> double {
        if constexpr (PrincipalModel<M>) return m.excess(sigma);
        else return 0;
      },
      model);
}

} // namespace

TEST(PrincipalReturn, StressLiesOnTheSurfaceAndItsWorkIsNotNegative) {
  std::mt19937 generator(21);
  for (const auto& m : materials()) {
    const double E = initial_E(m);
    long zones[4] = {};
    for (int i = 0; i < 10000; ++i) {
      const auto eps = random_strain(generator, E, 0.2);
      const PointUpdate u = update_one(m, eps, 0.1);
      ASSERT_FALSE(is_refused(u.status)) << model_name(m) << " sample " << i;
      ++zones[static_cast<int>(u.zone)];
      const double size = std::max({1.0, std::abs(u.sigma[0]), std::abs(u.sigma[1]), std::abs(u.sigma[2])});
      if (u.zone == Zone::elastic) EXPECT_LE(excess(m, u.sigma), 0);
      else {
        EXPECT_NEAR(excess(m, u.sigma), 0, 1e-8 * size);
        EXPECT_GE(u.plastic_work, -1e-12);
      }
      EXPECT_NEAR(u.phi, 0.1 - u.dv, 1e-15);
    }
    EXPECT_GT(zones[static_cast<int>(Zone::shear)], 100);
    EXPECT_GT(zones[static_cast<int>(Zone::tension)], 100);
  }
}

TEST(PrincipalReturn, TangentMatchesDifferencesWhereItHoldsStill) {
  std::mt19937 generator(22);
  const double h = 1e-7;
  int compared = 0, apart = 0;
  for (const auto& m : materials())
    for (int i = 0; i < 2000; ++i) {
      const double E = initial_E(m);
      const auto eps = random_strain(generator, E, 0.05);
      const PointUpdate u = update_one(m, eps, 0);
      double error = 0, kink = 0;
      for (int B = 0; B < 3; ++B) {
        auto up = eps, down = eps;
        up[B] += h, down[B] -= h;
        const PointUpdate a = update_one(m, up, 0), b = update_one(m, down, 0);
        for (int A = 0; A < 3; ++A) {
          error = std::max(error, std::abs((a.sigma[A] - b.sigma[A]) / (2 * h) - u.D[A][B]));
          kink = std::max({kink, std::abs(a.D[A][B] - b.D[A][B]), std::abs(a.D[A][B] - u.D[A][B])});
        }
      }
      if (kink > 1e-4 * E) {
        ++apart;
        continue;
      }
      ++compared;
      EXPECT_LT(error, 1e-6 * E + kink / 2) << i; // a difference over a bent stretch misses as much
    }
  EXPECT_GT(compared, 10 * apart);
}

TEST(PrincipalReturn, DoesNotCareForTheOrderOfTheStrains) {
  const std::array<double, 3> eps{0.002, -0.011, -0.004};
  for (const auto& m : materials()) {
    const PointUpdate u = update_one(m, eps, 0);
    std::array<int, 3> order{0, 1, 2};
    do {
      const PointUpdate v = update_one(m, {eps[order[0]], eps[order[1]], eps[order[2]]}, 0);
      for (int A = 0; A < 3; ++A) {
        EXPECT_NEAR(v.sigma[A], u.sigma[order[A]], 1e-12);
        for (int B = 0; B < 3; ++B) EXPECT_NEAR(v.D[A][B], u.D[order[A]][order[B]], 1e-9);
      }
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

TEST(DruckerPrager, SectionThatIsNearlyACircleReturnsAsACircle) {
  std::mt19937 generator(23);
  for (const DruckerPrager& circle : rocks()) {
    DruckerPrager nearly = circle;
    nearly.flow_stress_ratio = 1 - 1e-13;
    long plastic = 0;
    for (int i = 0; i < 3000; ++i) {
      const auto eps = random_strain(generator, circle.E, 0.05);
      const PointUpdate u = update_one(circle, eps, 0), v = update_one(nearly, eps, 0);
      ASSERT_EQ(u.zone, v.zone) << i;
      plastic += v.zone != Zone::elastic;
      const double size = std::max({1.0, std::abs(u.sigma[0]), std::abs(u.sigma[1]), std::abs(u.sigma[2])});
      for (int A = 0; A < 3; ++A) {
        EXPECT_NEAR(u.sigma[A], v.sigma[A], 1e-8 * size) << i;
        for (int B = 0; B < 3; ++B) EXPECT_NEAR(u.D[A][B], v.D[A][B], 1e-6 * circle.E) << i;
      }
      EXPECT_NEAR(u.dv, v.dv, 1e-9);
      EXPECT_NEAR(u.plastic_work, v.plastic_work, 1e-9 * size);
    }
    EXPECT_GT(plastic, 1000);
  }
}
