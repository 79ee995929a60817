#include "core/error.hpp"
#include "fit/doubt.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace platen;

/// A plastic particle: E = 2 GPa, sigma_y = 20 MPa, R = 1 mm; Hertz to first yield, then F = 2 pi R delta 2.8
/// sigma_y, joined.
fit::Claim granule(double length = 1, double force = 1, double gap = 0, double zero = 0) {
  fit::Claim claim;
  claim.radius_m = 1e-3;
  for (int i = 0; i < 200; ++i) {
    const double delta = 1e-6 * i, x = std::max(delta - gap, 0.0);
    claim.delta_m.push_back(length * delta);
    claim.force_N.push_back(force * (6.28e-3 * 56e6 * std::pow(x, 1.1) / std::pow(1e-4, 0.1)) + zero);
  }
  return claim;
}

std::string first(const fit::Claim& claim) {
  const auto doubts = fit::doubts_about(claim);
  return doubts.empty() ? "" : doubts.front().sentence;
}
bool refuses(const fit::Claim& claim) {
  for (const auto& doubt : fit::doubts_about(claim))
    if (doubt.refuses) return true;
  return false;
}

TEST(Doubt, AGoodCurveHasNone) {
  auto claim = granule();
  claim.E_Pa = 2e9, claim.nu = 0.3, claim.strength_Pa = 20e6, claim.R2 = 0.999;
  EXPECT_EQ(first(claim), "");
}

TEST(Doubt, MillimetresForMetresAreRefusedWithTheReadingThatMakesSense) {
  EXPECT_NE(first(granule(1000)).find("with mm instead of m, delta/R would end at 0.2"), std::string::npos);
  EXPECT_TRUE(refuses(granule(1000)));
}

TEST(Doubt, BetweenTheLawAndTheParticleItIsAFlag) {
  const auto claim = granule(4); // 0.8
  EXPECT_FALSE(first(claim).empty());
  EXPECT_FALSE(refuses(claim));
}

TEST(Doubt, AGapAndALoadCellOffZeroAreRefused) {
  EXPECT_TRUE(refuses(granule(1, 1, 20e-6)));
  EXPECT_TRUE(refuses(granule(1, 1, 0, 5)));
  auto fitted = granule(1, 1, 20e-6);
  fitted.contact_known = true;
  EXPECT_FALSE(refuses(fitted));
}

TEST(Doubt, ARowWithoutForceAmongThoseWithItIsRefused) {
  for (const double lost : {0.0, -0.4}) {
    auto claim = granule();
    claim.force_N[60] = lost;
    ASSERT_TRUE(refuses(claim));
    EXPECT_NE(first(claim).find("N at delta = 60 um, and was"), std::string::npos) << first(claim);
  }
  auto noise = granule(); // about no force, at the beginning of contact
  for (std::size_t i = 1; i < 4; ++i) noise.force_N[i] = i % 2 ? 0.2 : -0.2;
  EXPECT_EQ(first(noise), "");
}

TEST(Doubt, StifferThanHertzIsRefused) {
  auto claim = granule(1, 1);
  claim.E_Pa = 2e7; // typed 100 times too low
  EXPECT_NE(first(claim).find("as stiff as an elastic sphere"), std::string::npos);
  claim = granule(1, 102); // grams taken as newtons
  claim.E_Pa = 2e9;
  EXPECT_TRUE(refuses(claim));
}

TEST(Doubt, AMachineWithoutAParticleIsRefused) {
  fit::Claim claim;
  claim.radius_m = 1e-3;
  for (int i = 0; i < 100; ++i) claim.delta_m.push_back(1e-7 * i), claim.force_N.push_back(0.5 * i);
  EXPECT_NE(first(claim).find("no particle in it"), std::string::npos);
}

TEST(Doubt, StrengthAgainstModulus) {
  auto claim = granule();
  claim.E_Pa = 2e9, claim.strength_Pa = 3e9;
  EXPECT_NE(first(claim).find("is above the modulus"), std::string::npos);
  claim.strength_Pa = 1e9;
  EXPECT_TRUE(refuses(claim));
  claim.strength_Pa = 1e4;
  EXPECT_TRUE(refuses(claim));
}

TEST(Doubt, ABadFitAndAParameterOnItsBoundAreRefusedAndForceKeepsThemAsFlags) {
  auto claim = granule();
  claim.R2 = 0.056, claim.on_bound = {"a"};
  const auto doubts = fit::doubts_about(claim);
  ASSERT_EQ(doubts.size(), 2u);
  EXPECT_THROW((void)fit::pass(doubts, false), core::InvalidInput);
  EXPECT_EQ(fit::pass(doubts, true).size(), 2u);
  claim.R2 = std::nan(""), claim.on_bound = {}; // numbers too large for the fit
  EXPECT_THROW((void)fit::pass(fit::doubts_about(claim), false), core::InvalidInput);
}

} // namespace
