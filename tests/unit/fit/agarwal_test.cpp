// The fit of agarwal to a curve made from the published law.

#include "fit/agarwal.hpp"

#include "core/error.hpp"
#include "press/curve_csv.hpp"

#include <gtest/gtest.h>

#include <numbers>

using namespace platen;

namespace {

/// E/sigma_y = 100, nu = 0.3, with radius and force of the law multiplied.
press::Curve made(const char* experiment, law::LoadingCase loading, double end, double radius = 1,
                  double force = 1) {
  press::Curve curve;
  curve.radius_m = 0.01;
  curve.E_Pa = 20e9;
  curve.nu = 0.3;
  curve.sigma_ref_Pa = 200e6;
  curve.experiment = experiment;
  const auto law = law::AgarwalCurve<double>::make(loading, law::AgarwalVariant::published, 100 / (1 - 0.09),
                                                   100 / (3 * 0.4));
  for (int i = 1; i <= 100; ++i) {
    press::CurvePoint p;
    p.delta_bar = end * i / 100;
    p.delta_m = p.delta_bar * curve.radius_m;
    const auto point = law.at(p.delta_bar);
    p.contact_radius_m = radius * point.a * curve.radius_m;
    p.force_N = force * point.F * std::numbers::pi * curve.radius_m * curve.radius_m * curve.sigma_ref_Pa;
    curve.points.push_back(p);
  }
  return curve;
}

} // namespace

TEST(AgarwalFit, FindsTheRadiusThatMadeTheCurve) {
  for (const auto& [name, loading, end] : {std::tuple{"simple", law::LoadingCase::simple, 0.5},
                                           {"die", law::LoadingCase::die, 0.476},
                                           {"hydrostatic", law::LoadingCase::hydrostatic, 0.194}}) {
    const auto fit = fit::fit_agarwal(made(name, loading, end));
    EXPECT_NEAR(fit.fitted.D1 / fit.published.D1, 1, 1e-6) << name;
    EXPECT_NEAR(fit.fitted.D3 / fit.published.D3, 1, 1e-6) << name;
    EXPECT_NEAR(fit.fitted.D5 / fit.published.D5, 1, 1e-6) << name;
    EXPECT_LT(fit.radius_rms, 1e-12);
    EXPECT_GT(fit.compared, 20u);
    for (const auto& d : {fit.hardness, fit.radius, fit.force}) EXPECT_LT(d.largest, 1e-12) << name;
  }
}

TEST(AgarwalFit, TellsHowFarThePublishedLawIsOff) {
  const auto fit = fit::fit_agarwal(made("die", law::LoadingCase::die, 0.476, 1.1, 0.8));
  EXPECT_NEAR(fit.fitted.D3 / fit.published.D3, 1.1, 1e-6);
  EXPECT_NEAR(fit.radius.largest, 1 - 1 / 1.1, 1e-12);
  EXPECT_NEAR(fit.radius.rms, 1 - 1 / 1.1, 1e-12);
  EXPECT_NEAR(fit.force.rms, 1 / 0.8 - 1, 1e-12);
  EXPECT_NEAR(fit.hardness.rms, 1.1 * 1.1 / 0.8 - 1, 1e-12);
}

TEST(AgarwalFit, MakesACardThatReadsBackAsThePublishedLaw) {
  const auto curve = made("hydrostatic", law::LoadingCase::hydrostatic, 0.194);
  const auto card = fit::law_card(curve, fit::fit_agarwal(curve), "text");
  EXPECT_EQ(card.variant, "published");
  const auto law = std::get<law::Agarwal>(fit::make_law(card, {{"radius_m", "0.01"}}));
  const auto& p = curve.points[70];
  EXPECT_NEAR(law.loading(2 * p.delta_m).F, p.force_N, 1e-3 * p.force_N);
}

TEST(AgarwalFit, SaysWhatACurveLacks) {
  auto curve = made("die", law::LoadingCase::die, 0.476);
  curve.experiment = "local";
  EXPECT_THROW(fit::fit_agarwal(curve), core::InvalidInput);
  curve = made("die", law::LoadingCase::die, 0.476);
  curve.E_Pa = 0;
  EXPECT_THROW(fit::fit_agarwal(curve), core::InvalidInput);
  curve = made("die", law::LoadingCase::die, 0.476);
  for (auto& p : curve.points) p.contact_radius_m = 0;
  EXPECT_THROW(fit::fit_agarwal(curve), core::InvalidInput);
  curve = made("die", law::LoadingCase::die, 0.05); // nothing to compare with
  EXPECT_THROW(fit::law_card(curve, fit::fit_agarwal(curve), "text"), core::InvalidInput);
}
