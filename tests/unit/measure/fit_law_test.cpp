#include "measure/fit_law.hpp"

#include "core/error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace platen::measure {
namespace {

/// A press of lead that hardens as Ludwik says, roughly: H = F/(pi a^2) grows from 2.8 sigma_y to 12.
InputCurve ludwik() {
  InputCurve input;
  input.file = "curve.csv";
  auto& c = input.curve;
  c.radius_m = 1e-3, c.sigma_ref_Pa = 5e6, c.E_Pa = 1e10, c.nu = 0.435;
  c.experiment = "simple";
  for (int i = 1; i <= 100; ++i) {
    press::CurvePoint p;
    p.delta_bar = 0.005 * i, p.delta_m = p.delta_bar * c.radius_m;
    p.contact_radius_m =
        c.radius_m * std::sqrt(p.delta_bar) * (1.35 - 1.1 * p.delta_bar + 1.7 * p.delta_bar * p.delta_bar);
    p.mean_pressure_Pa = c.sigma_ref_Pa * (2.8 + 9 * std::sqrt(p.delta_bar));
    p.force_N = std::numbers::pi * std::pow(p.contact_radius_m, 2) * p.mean_pressure_Pa;
    p.F_bar = p.force_N / (std::numbers::pi * c.radius_m * c.radius_m * c.sigma_ref_Pa);
    c.points.push_back(p);
  }
  return input;
}

std::string refusal(const FitOptions& o) {
  try {
    (void)fit_law(ludwik(), o, [](const auto&) {});
  } catch (const core::InvalidInput& error) { return error.what(); }
  return {};
}

FitOptions shahin(double inverse_m, std::optional<double> kappa) {
  FitOptions o;
  o.law = "shahin", o.inverse_m = inverse_m, o.sigma_ref_Pa = kappa;
  return o;
}

TEST(FitLaw, TakesNoYieldStressForKappa) {
  EXPECT_NE(refusal(shahin(0.24, {})).find("give the kappa"), std::string::npos);
  EXPECT_EQ(refusal(shahin(0.24, 20.5e6)), "");
}

TEST(FitLaw, SaysWhatEndedOnABound) {
  const auto fitting = fit_law(ludwik(), shahin(0.24, 5e6), [](const auto&) {});
  ASSERT_EQ(fitting.doubts.size(), 1u);
  EXPECT_NE(fitting.doubts[0].find("H_max"), std::string::npos) << fitting.doubts[0];
  ASSERT_TRUE(fitting.card);
  EXPECT_NE(std::get<std::string>(fit::value_of(fitting.card->provenance, "doubts")).find("bound"),
            std::string::npos);
}

} // namespace
} // namespace platen::measure
