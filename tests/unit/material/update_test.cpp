// The implicit update of every model: on the surface, consistent, dissipative, objective in its invariants.

#include "material/models.hpp"
#include "random_states.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

using namespace platen::material;
using namespace platen::material::testing;

namespace {

/// `check(model)` for every plastic material of these tests.
template <class Check> void for_all_materials(Check check) {
  for (const auto& m : corner_materials()) check(m);
  for (const auto& m : metals()) check(m);
  for (const auto& m : rocks()) check(m);
  for (const auto& m : caps()) check(m);
}

} // namespace

TEST(Update, ZeroStrainGivesZeroStress) {
  const auto check = [](const Model& model) {
    const PointUpdate u = update_one(model, {0, 0, 0}, 0);
    EXPECT_EQ(u.status, Status::elastic) << model_name(model);
    for (const double s : u.sigma) EXPECT_EQ(s, 0) << model_name(model);
  };
  for_all_materials(check);
  for (const Dpc& m : caps(true)) check(m);
  check(Elastic{100, 0.3});
  check(MohrCoulomb{1000, 0.2, 27.8, 0.3, 27.8, 0.05});
}

TEST(Update, StressIsContinuousWhereZonesMeet) {
  // Between two strains in different zones, halved until they are neighbours.
  std::mt19937 generator(12);
  std::map<std::pair<Zone, Zone>, int> met;
  const auto check = [&](const Model& model, Trial a, const Trial& other, double K) {
    std::array<double, 3> b = other.eps;
    PointUpdate at_a = update_one(model, a.eps, a.phi), at_b = update_one(model, b, a.phi);
    for (int halving = 0; halving < 60 && at_a.zone != at_b.zone; ++halving) {
      std::array<double, 3> middle;
      for (int A = 0; A < 3; ++A) middle[A] = (a.eps[A] + b[A]) / 2;
      if (middle == a.eps || middle == b) break;
      const PointUpdate u = update_one(model, middle, a.phi);
      (u.zone == at_a.zone ? a.eps : b) = middle;
      (u.zone == at_a.zone ? at_a : at_b) = u;
    }
    if (at_a.zone == at_b.zone) return;
    ++met[std::minmax(at_a.zone, at_b.zone)];
    for (int A = 0; A < 3; ++A)
      EXPECT_NEAR(at_a.sigma[A], at_b.sigma[A], 1e-9 * K)
          << model_name(model) << " between zones " << int(at_a.zone) << " and " << int(at_b.zone);
    EXPECT_NEAR(at_a.phi, at_b.phi, 1e-9) << model_name(model);
  };
  const auto check_many = [&](const auto& m) {
    for (int i = 0; i < 200; ++i) {
      const Trial a = random_trial(m, generator, 0.1), b = random_trial(m, generator, 0.1);
      check(m, a, b, m.moduli(a.phi).K);
    }
  };
  for_all_materials(check_many);
  for (const Dpc& m : caps(true)) check_many(m);
  std::uniform_real_distribution<double> strain(-0.05, 0.05);
  const auto random_strain = [&] {
    return Trial{{strain(generator), strain(generator), strain(generator)}, 0};
  };
  for (const double psi : {0.0, 15.0, 27.8})
    for (int i = 0; i < 200; ++i)
      check(MohrCoulomb{1000, 0.2, 27.8, 0.3, psi, 0.05}, random_strain(), random_strain(), 1000);
  EXPECT_GE(std::ranges::count_if(met, [](const auto& pair) { return pair.second > 50; }), 5)
      << "elastic with shear, compaction and tension; shear with both";
}

TEST(Update, SmallStrainIsHookesLaw) {
  const double E = 200, nu = 0.25, e = 1e-7;
  const PointUpdate u = update_one(Elastic{E, nu}, {e, 0, 0}, 0);
  EXPECT_NEAR(u.sigma[0], E * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) * e, 1e-5 * E * e);
  EXPECT_NEAR(u.sigma[1], E * nu / ((1 + nu) * (1 - 2 * nu)) * e, 1e-5 * E * e);
}

TEST(Update, PlasticStressLiesOnTheSurface) {
  std::mt19937 generator(7);
  for_all_materials([&](const auto& m) {
    for (int i = 0; i < 3000; ++i) {
      const Trial t = random_trial(m, generator, 0.2);
      const PointUpdate u = update_one(m, t.eps, t.phi);
      ASSERT_FALSE(is_refused(u.status)) << "E " << m.E << " sample " << i;
      ASSERT_TRUE(std::isfinite(u.p) && std::isfinite(u.q) && std::isfinite(u.phi));
      if (u.zone == Zone::elastic) continue;
      EXPECT_NEAR(yield_ratio(m.surface(u.phi), u.p, u.q), 1, 1e-8) << "E " << m.E << " sample " << i;
      EXPECT_GE(u.p * u.dv + u.q * u.dw, 0) << "plastic power";
    }
  });
}

TEST(Update, DensityFollowsThePlasticVolume) {
  std::mt19937 generator(8);
  const Vmdc m = corner_materials()[4];
  for (int i = 0; i < 1000; ++i) {
    const Trial t = random_trial(m, generator, 0.1);
    const PointUpdate u = update_one(m, t.eps, t.phi);
    EXPECT_NEAR(u.phi, t.phi - u.dv, 1e-12);
  }
}

TEST(Update, TangentMatchesCentralDifferences) {
  std::mt19937 generator(9);
  const double h = 1e-6;
  long compared = 0;
  const auto check = [&](const Model& model, const Trial& t, double curvature) {
    const PointUpdate u = update_one(model, t.eps, t.phi);
    double scale = 0, error = 0;
    bool smooth = !is_refused(u.status);
    for (int B = 0; B < 3; ++B) {
      // Fourth order, so that the difference quotient is not the limit of the comparison.
      std::array<PointUpdate, 4> at;
      const double steps[4] = {-2 * h, -h, h, 2 * h};
      for (int k = 0; k < 4; ++k) {
        auto eps = t.eps;
        eps[B] += steps[k];
        at[k] = update_one(model, eps, t.phi);
        smooth = smooth && at[k].zone == u.zone;
      }
      for (int A = 0; A < 3; ++A) {
        const double slope =
            (at[0].sigma[A] - 8 * at[1].sigma[A] + 8 * at[2].sigma[A] - at[3].sigma[A]) / (12 * h);
        error = std::max(error, std::abs(slope - u.D[A][B]));
        scale = std::max(scale, std::abs(u.D[A][B]));
      }
    }
    // Where the increment is not large against h, the difference quotient itself is inexact.
    if (!smooth || invariants(t.eps).eps_q < 300 * h || curvature < 3000 * h) return;
    ++compared;
    EXPECT_LT(error, 1e-6 * std::max(scale, 1.0)); // strengths are about 1; at an apex the tangent is 0
  };
  for (const Vmdc& m : corner_materials())
    for (int i = 0; i < 400; ++i) {
      const Trial t = random_trial(m, generator, 0.1);
      // The tensile cap is Lambda/K wide in strain.
      check(m, t, m.surface(t.phi).Lambda / m.moduli(t.phi).K);
    }
  for (const VonMises& m : metals())
    for (int i = 0; i < 400; ++i) check(m, random_trial(m, generator, 0.1), 1);
  for (const DruckerPrager& m : rocks())
    for (int i = 0; i < 400; ++i) check(m, random_trial(m, generator, 0.1), 1);
  for (const bool published : {false, true})
    for (const Dpc& m : caps(published))
      for (int i = 0; i < 200; ++i) {
        const Trial t = random_trial(m, generator, 0.1);
        check(m, t, m.surface(t.phi).Lambda.x / m.moduli(t.phi).K);
      }
  EXPECT_GT(compared, 3000);
}

TEST(Update, TangentOfPerfectPlasticityIsSymmetricThatOfElasticityInKirchhoffStress) {
  // Yield and flow in Cauchy stress: d(sigma)/d(eps) is symmetric. Elasticity has its energy in tau = J_e
  // sigma, and d(tau_A)/d(eps_B) = J_e (D_AB + sigma_A): there D_AB - D_BA = sigma_B - sigma_A.
  std::mt19937 generator(10);
  int plastic = 0, elastic = 0;
  for (int i = 0; i < 500; ++i) {
    Trial t = random_trial(corner_materials()[8], generator, 0.01);
    if (i % 2) // before yield
      for (double& strain : t.eps) strain *= 5e-6 / 0.01;
    const PointUpdate u = update_one(VonMises{1e5, 0.3, 1}, t.eps, 0);
    const bool yields = u.q > 1 - 1e-6;
    ++(yields ? plastic : elastic);
    double scale = 0;
    for (int A = 0; A < 3; ++A)
      for (int B = 0; B < 3; ++B) scale = std::max(scale, std::abs(u.D[A][B]));
    for (int A = 0; A < 3; ++A)
      for (int B = 0; B < 3; ++B)
        EXPECT_NEAR(u.D[A][B] - u.D[B][A], yields ? 0 : u.sigma[B] - u.sigma[A], 1e-10 * scale);
  }
  EXPECT_GT(plastic, 100);
  EXPECT_GT(elastic, 100);
}

TEST(Update, RefusesNothingInsideTheParameterSpace) {
  // Increments up to 20 %: none may fail, none may be NaN.
  std::mt19937 generator(11);
  long refused = 0;
  for (const Vmdc& m : corner_materials())
    for (int i = 0; i < 5000; ++i) {
      const Trial t = random_trial(m, generator, 0.2);
      const PointUpdate u = update_one(m, t.eps, t.phi);
      if (is_refused(u.status)) ++refused;
      else ASSERT_FALSE(std::isnan(u.sigma[0] + u.D[0][0] + u.phi));
    }
  EXPECT_EQ(refused, 0);
}
