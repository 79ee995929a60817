// The return in principal stresses: on the surface, its corners included, consistent, dissipative.

#include "random_states.hpp"

#include <gtest/gtest.h>

#include <algorithm>

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

} // namespace

TEST(MohrCoulomb, StressLiesOnTheSurfaceAndItsWorkIsNotNegative) {
  std::mt19937 generator(21);
  for (const auto& m : rocks_by_mohr()) {
    long zones[4] = {};
    for (int i = 0; i < 10000; ++i) {
      const auto eps = random_strain(generator, m.E, 0.2);
      const PointUpdate u = update_one(m, eps, 0.1);
      ASSERT_FALSE(is_refused(u.status)) << m.psi_deg << " sample " << i;
      ++zones[static_cast<int>(u.zone)];
      const double size = std::max({1.0, std::abs(u.sigma[0]), std::abs(u.sigma[1]), std::abs(u.sigma[2])});
      if (u.zone == Zone::elastic) EXPECT_LE(m.excess(u.sigma), 0);
      else {
        EXPECT_NEAR(m.excess(u.sigma), 0, 1e-8 * size);
        EXPECT_GE(u.plastic_work, -1e-12);
      }
      EXPECT_NEAR(u.phi, 0.1 - u.dv, 1e-15);
    }
    EXPECT_GT(zones[static_cast<int>(Zone::shear)], 100);
    EXPECT_GT(zones[static_cast<int>(Zone::tension)], 100);
  }
}

TEST(MohrCoulomb, TangentMatchesDifferencesWhereTheSetOfPlanesStays) {
  std::mt19937 generator(22);
  const double h = 1e-7;
  int compared = 0, apart = 0;
  for (const auto& m : rocks_by_mohr())
    for (int i = 0; i < 2000; ++i) {
      const auto eps = random_strain(generator, m.E, 0.05);
      const PointUpdate u = update_one(m, eps, 0);
      double error = 0, kink = 0;
      for (int B = 0; B < 3; ++B) {
        auto up = eps, down = eps;
        up[B] += h, down[B] -= h;
        const PointUpdate a = update_one(m, up, 0), b = update_one(m, down, 0);
        for (int A = 0; A < 3; ++A) {
          error = std::max(error, std::abs((a.sigma[A] - b.sigma[A]) / (2 * h) - u.D[A][B]));
          kink = std::max(kink, std::abs(a.D[A][B] - b.D[A][B]));
        }
      }
      if (kink > 1e-4 * m.E) {
        ++apart;
        continue;
      }
      ++compared;
      EXPECT_LT(error, 1e-6 * m.E) << i;
    }
  EXPECT_GT(compared, 10 * apart);
}

TEST(MohrCoulomb, DoesNotCareForTheOrderOfTheStrains) {
  const MohrCoulomb m = rocks_by_mohr()[1];
  const std::array<double, 3> eps{0.002, -0.011, -0.004};
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
