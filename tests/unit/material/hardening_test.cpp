// Yield stress over equivalent plastic strain, law by law.

#include "material/hardening.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace platen::material;

namespace {

constexpr double E = 1000;
const std::vector<std::pair<const char*, Hardening>> laws = {
    {"none", PerfectlyPlastic{}},
    {"exponential", ExponentialHardening{3}},
    {"Hollomon", Hollomon{2, 0.25}},
    {"Hollomon, almost straight", Hollomon{2, 0.99996}},
    {"Hollomon, almost flat", Hollomon{2, 3.64464e-05}}, // Shahin, Table E.1, die, first row
    {"Ludwik", Ludwik{3.1, 0.35}},
    {"Ludwik, straight", Ludwik{3.1, 1}},
    {"Ludwik, bent upwards", Ludwik{3.1, 2}},
    {"table", HardeningTable{{0, 0.1, 0.4}, {1, 2, 2.5}}},
};

double sigma(const Hardening& h, double eps_p) { return yield_stress(h, E, 1, eps_p).value; }

} // namespace

TEST(Hardening, BeginsAtTheInitialYieldStress) {
  for (const auto& [name, h] : laws) {
    const double sigma_y = initial_yield_stress(h, E, 1);
    EXPECT_NEAR(sigma(h, 0), sigma_y, 1e-12 * sigma_y + 1e-290) << name;
  }
}

TEST(Hardening, SlopeIsTheDerivative) {
  for (const auto& [name, h] : laws)
    for (const double eps_p : {1e-4, 0.03, 0.2, 0.8}) {
      const double step = 1e-5 * eps_p;
      const double slope = (sigma(h, eps_p + step) - sigma(h, eps_p - step)) / (2 * step);
      EXPECT_NEAR(yield_stress(h, E, 1, eps_p).slope, slope, 1e-6 * (std::abs(slope) + 1)) << name;
    }
}

TEST(Hardening, HasAFiniteSlopeAtZeroWhereTheLawItselfHasNone) {
  // Hollomon: (E/m)/(1 - 1/m); Ludwik: eps_0 = (K/(10 n E))^{n/(n - 1)}, slope (2 - 1/n) K eps_0^{1/n - 1}.
  EXPECT_NEAR(yield_stress(Hollomon{2, 0.25}, E, 1, 0).slope, E * 0.25 / 0.75, 1e-9 * E);
  const double e = 0.35, K = 3.1, eps_0 = std::pow(e * K / (10 * E), 1 / (1 - e));
  EXPECT_NEAR(yield_stress(Ludwik{K, e}, E, 1, 0).slope, (2 - e) * K * std::pow(eps_0, e - 1), 1e-6 * E);
  EXPECT_LT(eps_0, 1e-5);
}

TEST(Hardening, LudwikIsItselfBeyondItsFirstBend) {
  for (const double eps_p : {1e-5, 1e-3, 0.1, 1.0})
    EXPECT_NEAR(sigma(Ludwik{3.1, 0.35}, eps_p), 1 + 3.1 * std::pow(eps_p, 0.35), 1e-12);
}

TEST(Hardening, HollomonIsAPowerOfTheTotalStrain) {
  for (const double e : {3.64464e-05, 0.25, 0.9, 0.99996, 1.0})
    for (const double eps_p : {1e-6, 1e-3, 0.1, 1.0, 3.0}) {
      const double s = sigma(Hollomon{2, e}, eps_p);
      EXPECT_NEAR(s, 2 * std::pow(eps_p + s / E, e), 1e-12) << e << " " << eps_p;
    }
}

TEST(Hardening, TableIsStraightBetweenAndHeldBeyond) {
  const HardeningTable table{{0, 0.1, 0.4}, {1, 2, 2.5}};
  EXPECT_DOUBLE_EQ(sigma(table, 0.05), 1.5);
  EXPECT_DOUBLE_EQ(sigma(table, 0.1), 2);
  EXPECT_DOUBLE_EQ(sigma(table, 0.25), 2.25);
  EXPECT_DOUBLE_EQ(sigma(table, 7), 2.5);
}
