#include "surrogate/yield_from.hpp"

#include "core/error.hpp"
#include "surrogate/assess.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace platen::surrogate {
namespace {

TEST(YieldFromHardness, IsTabors) {
  EXPECT_NEAR(yield_from_hardness(2e11, 0.3, 1.96e9), 0.7e9, 1e-3 * 0.7e9);
}

TEST(YieldFromHardness, IsRefusedWhereTheIndentationIsPartlyElastic) {
  EXPECT_THROW(yield_from_hardness(2e9, 0.35, 2e8), core::InvalidInput); // a glassy polymer
  EXPECT_THROW(yield_from_hardness(2e11, 0.3, -1), core::InvalidInput);
  EXPECT_THROW(yield_from_hardness(2e11, 0.6, 1e9), core::InvalidInput);
}

TEST(GranuleFromIndices, IsTheCompactAtItsDensity) {
  const Indices known{0.02, 0.01, 56e6, 0.9};
  const auto g = granule_from(known);
  EXPECT_EQ(g.rho_r0, 0.7);
  EXPECT_DOUBLE_EQ(g.Gamma, g.sigma_y); // of the base case
  const double phi = std::log(known.relative_density / g.rho_r0);
  ASSERT_NEAR(g.rho_r(phi), known.relative_density, 1e-12);
  const auto moduli = g.moduli(phi);
  const double E = 9 * moduli.K * moduli.G / (3 * moduli.K + moduli.G), nu = E / (2 * moduli.G) - 1;
  EXPECT_NEAR(E / (1 - nu * nu), 56e6 / 0.02, 1e-6 * 56e6 / 0.02);
  const auto strengths = g.strengths(phi);
  EXPECT_NEAR(strengths.Gamma, 20e6, 1);
  const double sigma_T = 0.01 * 56e6; // p = q/3 of tension along one axis is on the tension cap
  EXPECT_NEAR(std::hypot(sigma_T / 3 / strengths.Lambda, sigma_T / strengths.Gamma), 1, 1e-9);
}

TEST(GranuleFromIndices, RefusesWhatNoCompactHas) {
  for (const Indices& wrong : {Indices{0.2, 0.01, 56e6, 0.9},
                               {0.02, 0.4, 56e6, 0.9},
                               {0.02, 0.01, -1, 0.9},
                               {0.02, 0.01, 56e6, 90},
                               {0, 0.01, 56e6, 0.9},
                               {0.02, std::nan(""), 56e6, 0.9}})
    EXPECT_THROW(granule_from(wrong), core::InvalidInput);
}

TEST(YieldFromHeckel, IsAThirdOfTheYieldPressure) {
  EXPECT_DOUBLE_EQ(yield_from_heckel(5e9, 0.3, 75e6), 25e6);
  EXPECT_THROW(yield_from_heckel(5e9, 0.3, 6e8), core::InvalidInput); // springs back
  EXPECT_THROW(yield_from_heckel(5e9, 0.3, 0), core::InvalidInput);
  EXPECT_THROW(yield_from_heckel(5e9, 0.3, std::nan("")), core::InvalidInput);
}

// CalculiX 2.20, three meshes: von Mises, E/sigma_y = 100, nu = 0.3, F/(pi R^2 sigma_y) at delta/R.
TEST(YieldFromCrushing, GivesBackTheStressOfAKnownSphere) {
  constexpr double sigma_y = 2e7, E = 100 * sigma_y, R = 1e-3;
  for (const auto& [x, F_bar] :
       {std::pair{0.05, 0.2209}, {0.1, 0.423}, {0.2, 0.611}, {0.3, 0.749}, {0.4, 0.939}}) {
    const double F = std::numbers::pi * R * R * sigma_y * F_bar;
    EXPECT_NEAR(yield_from_crushing(E, 0.3, F, x * R, R), sigma_y, 0.03 * sigma_y) << x;
  }
}

TEST(YieldFromCrushing, RefusesWhatNoYieldStressGives) {
  constexpr double E = 2e9, R = 1e-3;
  EXPECT_THROW(yield_from_crushing(E, 0.3, 1e4, 1e-4, R), core::InvalidInput);  // more than E allows
  EXPECT_THROW(yield_from_crushing(E, 0.3, 1e-4, 1e-4, R), core::InvalidInput); // next to nothing
  EXPECT_THROW(yield_from_crushing(E, 0.3, 10, 0.9e-3, R), core::InvalidInput); // too far
}

} // namespace
} // namespace platen::surrogate
