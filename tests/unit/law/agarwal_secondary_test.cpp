#include "platen/law/agarwal_secondary.hpp"

#include <gtest/gtest.h>

namespace {

using namespace platen::law;

TEST(AgarwalSecondary, DisplacementIsTheFigureInMillimetresForTenMillimetres) {
  // (2.49) as printed: gamma = 2 mm at R = 10 mm, lambda = 1000
  const double lambda = 1000, tau = 1 / (1480.8863 * std::tanh(5.0261e-5 * std::pow(lambda, 1.2889)));
  const double omega = 5.7775 * std::tanh(0.0159 * std::pow(lambda, 0.6146));
  const double gamma_s_mm = tau * std::pow(2.0, omega);
  EXPECT_NEAR(secondary_overlap(lambda, 2.0 / 20), gamma_s_mm / 20, 1e-15);
}

TEST(AgarwalSecondary, SidesMoveLessThanTheEnds) {
  for (double lambda : {163.0, 1000.0, 4954.0})
    for (double x : {0.02, 0.05, 0.1}) EXPECT_LT(secondary_overlap(lambda, x), x);
}

TEST(AgarwalSecondary, OnsetMeetsTheDensityCondition) { // (2.28) with (2.52)
  const auto c = AgarwalCurve<double>::make(LoadingCase::die, AgarwalVariant::published, 386.40, 300);
  const double x = secondary_onset(386.40);
  EXPECT_NEAR(x, 0.4115, 1e-12);
  const double a = *secondary_contact(c, x).a_bar, pi = std::numbers::pi;
  EXPECT_NEAR(pi * pi * a * a / (144 * (1 - x) * (1 - x)), 0.0593, 1e-12);
}

TEST(AgarwalSecondary, SaysNothingWhereTheThesisSaysNothing) {
  const auto c = AgarwalCurve<double>::make(LoadingCase::die, AgarwalVariant::published, 386.40, 300);
  EXPECT_FALSE(secondary_contact(c, 0.2).H_bar);
  EXPECT_TRUE(secondary_contact(c, 0.09).F_bar);
  EXPECT_FALSE(secondary_contact(c, 0.45).F_bar);
  EXPECT_EQ(*secondary_contact(c, 0.45).H_bar, c.at(0.45).H); // all contacts under one pressure
}

} // namespace
