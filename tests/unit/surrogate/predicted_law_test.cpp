#include "core/error.hpp"
#include "surrogate/predicted_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace platen::surrogate {
namespace {

material::Material metal() { return {"metal", material::VonMises{2e9, 0.3, 2e7}}; }

/// An answer of five knots.
Answer answer() {
  Answer a;
  a.surrogate.pool = "metals";
  a.surrogate.model = "von-mises";
  a.surrogate.engine = 6;
  a.surrogate.knots = {0.01, 0.05, 0.1, 0.2, 0.3, 0.35, 0.4, 0.45, 0.5};
  a.surrogate.unload_delta_bar = {0.1, 0.3, 0.5};
  a.prediction = {{0.03, 0.2, 0.4, 0.7, 0.9, 1, 1.1, 1.2, 1.3},
                  {0.14, 0.3, 0.45, 0.6, 0.75, 0.8, 0.85, 0.9, 1},
                  {1.4, 1.3, 0.98},
                  {2, 4, 6},
                  std::vector<double>(9, 0.01),
                  std::vector<double>(9, 0.01)};
  a.assessment.knots = 9;
  a.sigma_ref = 2e7;
  return a;
}

TEST(PressedCard, HoldsTheCurveAndWhereItIsFrom) {
  const auto card = pressed_card(answer(), metal());
  EXPECT_EQ(card.law, "pressed");
  EXPECT_EQ(card.parameters.at("sigma_ref_Pa"), "2e7");
  EXPECT_EQ(card.parameters.at("F_bar"), "0.03,0.2,0.4,0.7,0.9,1,1.1,1.2,1.3");
  EXPECT_EQ(card.parameters.at("alpha"), "1.4,1.3,1") << "a law takes no exponent below 1";
  EXPECT_EQ(std::get<std::string>(fit::value_of(card.provenance, "pool")), "metals");
  EXPECT_EQ(std::get<std::string>(fit::value_of(card.provenance, "verdict")), "inside");
  EXPECT_EQ(std::get<std::vector<double>>(fit::value_of(card.errors, "band_90")).size(), 9U);
}

TEST(PressedCard, EndsWhereTheCurveIsNoLongerCertain) {
  auto a = answer();
  a.assessment.knots = 5;
  const auto card = pressed_card(a, metal());
  EXPECT_EQ(card.parameters.at("delta_bar"), "0.01,0.05,0.1,0.2,0.3");
  EXPECT_EQ(card.parameters.at("unload_delta_bar"), "0.1,0.3");
  EXPECT_EQ(card.delta_bar->back(), 0.3);
}

TEST(PressedCard, HoldsASmallDipLevelAndSaysSo) {
  auto a = answer();
  a.prediction.F_bar[4] = 0.695;
  const auto card = pressed_card(a, metal());
  EXPECT_NEAR(std::get<double>(fit::value_of(card.errors, "held_level")), 0.0072, 1e-4);
  a.prediction.F_bar[4] = 0.5;
  EXPECT_THROW((void)pressed_card(a, metal()), core::InvalidInput);
}

TEST(EdmansSinkaCard, IsFittedToThePredictedCurve) {
  const auto card = edmans_sinka_card(answer(), metal(), "published");
  EXPECT_EQ(card.law, "edmans-sinka");
  EXPECT_LT(std::get<double>(fit::value_of(card.errors, "relative_l2")), 0.2);
  EXPECT_EQ(std::get<double>(fit::value_of(card.errors, "predicted_curve")), 0.01);
}

} // namespace
} // namespace platen::surrogate
