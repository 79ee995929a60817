// Fits of agarwal and shahin to curves made from laws with known coefficients.

#include "fit/agarwal.hpp"
#include "fit/shahin.hpp"

#include "core/error.hpp"
#include "platen/law/agarwal.hpp"
#include "platen/law/agarwal_secondary.hpp"
#include "platen/law/shahin.hpp"

#include <gtest/gtest.h>

#include <numbers>

using namespace platen;
using law::LoadingCase;

namespace {

struct Loaded {
  const char* name;
  LoadingCase loading;
  double end;
};
constexpr Loaded all[] = {{"simple", LoadingCase::simple, 0.5},
                          {"die", LoadingCase::die, 0.476},
                          {"hydrostatic", LoadingCase::hydrostatic, 0.194}};

constexpr double lambda = 100 / (1 - 0.09), zeta = 100 / (3 * 0.4); // E/sigma_y = 100, nu = 0.3

law::AgarwalCoefficients<double> published(LoadingCase loading) {
  return law::AgarwalCoefficients<double>::published(loading, lambda, zeta);
}

/// Other numbers, of those that a curve of this loading determines.
law::AgarwalCoefficients<double> changed(LoadingCase loading) {
  auto c = published(loading);
  c.D1 *= 0.98, c.D3 *= 1.1, c.D5 *= 0.9, c.H_max *= 0.97, c.x_h *= 1.05;
  if (loading == LoadingCase::simple) c.q *= 1.1, c.r *= 1.05;
  else c.x_min *= 1.08, c.H_min *= 1.05, c.l *= 0.98;
  return c;
}

/// E/sigma_ref = 100, with radius and force of the law multiplied.
template <class Law>
press::Curve made(const Loaded& loaded, const Law& law, double radius = 1, double force = 1) {
  press::Curve curve;
  curve.radius_m = 0.01;
  curve.E_Pa = 20e9;
  curve.nu = 0.3;
  curve.sigma_ref_Pa = 200e6;
  curve.experiment = loaded.name;
  for (int i = 1; i <= 100; ++i) {
    press::CurvePoint p;
    p.delta_bar = loaded.end * i / 100;
    p.delta_m = p.delta_bar * curve.radius_m;
    const auto point = law.at(p.delta_bar);
    p.contact_radius_m = radius * point.a * curve.radius_m;
    p.force_N = force * point.F * std::numbers::pi * curve.radius_m * curve.radius_m * curve.sigma_ref_Pa;
    curve.points.push_back(p);
  }
  return curve;
}

press::Curve made(const Loaded& loaded, const law::AgarwalCoefficients<double>& c, double radius = 1,
                  double force = 1) {
  return made(
      loaded,
      law::AgarwalCurve<double>::make(loaded.loading, law::AgarwalVariant::published, lambda, zeta, c),
      radius, force);
}

} // namespace

TEST(AgarwalFit, FindsTheCoefficientsThatMadeTheCurve) {
  for (const auto& loaded : all)
    for (const auto& c : {published(loaded.loading), changed(loaded.loading)}) {
      const auto fit = fit::fit_agarwal(made(loaded, c));
      EXPECT_EQ(fit.fitted.x_joined, fit.x_from);
      for (const auto& key : law::agarwal_coefficients) {
        if (key.key == "x_joined") continue;
        EXPECT_NEAR(fit.fitted.*key.member / (c.*key.member), 1, 1e-4) << loaded.name << ' ' << key.key;
      }
      EXPECT_GT(fit.of_fitted.points, 20U);
      for (const auto& d : {fit.of_fitted.hardness, fit.of_fitted.radius, fit.of_fitted.force})
        EXPECT_LT(d.largest, 1e-5) << loaded.name;
      EXPECT_EQ(fit.Gamma.has_value(), loaded.loading != LoadingCase::simple);
    }
  EXPECT_NEAR(*fit::fit_agarwal(made(all[1], published(LoadingCase::die))).Gamma, 0.0593, 1e-5);
}

TEST(AgarwalFit, TellsHowFarThePublishedLawIsOff) {
  const auto fit = fit::fit_agarwal(made(all[1], published(LoadingCase::die), 1.1, 0.8));
  EXPECT_NEAR(fit.fitted.D3 / fit.published.D3, 1.1, 1e-6);
  const auto& d = fit.of_published;
  EXPECT_NEAR(d.radius.largest, 1 - 1 / 1.1, 1e-12);
  EXPECT_NEAR(d.radius.rms, 1 - 1 / 1.1, 1e-12);
  EXPECT_NEAR(d.force.rms, 1 / 0.8 - 1, 1e-12);
  EXPECT_NEAR(d.hardness.rms, 1.1 * 1.1 / 0.8 - 1, 1e-12);
}

TEST(AgarwalFit, MakesACardThatReadsBackAsTheFittedLaw) {
  for (const auto& loaded : all) {
    const auto curve = made(loaded, changed(loaded.loading));
    const auto card = fit::law_card(curve, fit::fit_agarwal(curve), "text");
    const auto law = law::formulas<law::AgarwalMaterial>({card.law, card.variant, card.parameters}, 0.01);
    const auto& p = curve.points[70];
    EXPECT_NEAR(law.loading(2 * p.delta_m).F, p.force_N, 1e-3 * p.force_N) << loaded.name;
    EXPECT_NEAR(law.loading(2 * p.delta_m).a, p.contact_radius_m, 1e-3 * p.contact_radius_m) << loaded.name;
  }
}

TEST(AgarwalFit, TheErrorsOfACardAreThoseOfItsLaw) {
  for (const auto& loaded : all) {
    auto c = changed(loaded.loading);
    c.x_h *= 1.5; // a fit may find it far from the published one
    const auto curve = made(loaded, c, 1.01);
    const auto fit = fit::fit_agarwal(curve);
    const auto card = fit::law_card(curve, fit, "text");
    const auto law = law::formulas<law::AgarwalMaterial>({card.law, card.variant, card.parameters}, 0.01);
    double force = 0, radius = 0;
    for (const auto& p : curve.points) {
      if (p.delta_bar < fit.of_fitted.from || p.delta_bar > fit.of_fitted.to) continue;
      force = std::max(force, std::abs(law.loading(2 * p.delta_m).F / p.force_N - 1));
      radius = std::max(radius, std::abs(law.loading(2 * p.delta_m).a / p.contact_radius_m - 1));
    }
    EXPECT_NEAR(std::get<double>(fit::value_of(card.errors, "force_largest")), force, 2e-4) << loaded.name;
    EXPECT_NEAR(std::get<double>(fit::value_of(card.errors, "radius_largest")), radius, 2e-4) << loaded.name;
  }
}

TEST(AgarwalFit, LeavesAsPublishedWhatTheCurveDoesNotReach) {
  auto curve = made(all[1], changed(LoadingCase::die));
  curve.points.resize(50); // to 0.238, before pressure is least
  const auto fit = fit::fit_agarwal(curve);
  const std::vector<std::string_view> expected = {"D_3", "D_5", "q", "r", "x_min", "H_min", "l"};
  EXPECT_EQ(fit.held, expected);
  EXPECT_EQ(fit.fitted.H_min, fit.published.H_min);
  EXPECT_FALSE(fit.Gamma);
}

TEST(AgarwalFit, ReadsTheSidesOfAParticle) {
  auto curve = made(all[0], published(LoadingCase::simple));
  for (auto& p : curve.points)
    p.equator_displacement_m = law::secondary_overlap(lambda, p.delta_bar) * curve.radius_m;
  const auto sides = fit::side_motion(curve);
  ASSERT_TRUE(sides);
  EXPECT_NEAR(sides->tau, law::side_motion(lambda).tau, 1e-5);
  EXPECT_NEAR(sides->omega, law::side_motion(lambda).omega, 1e-5);
  EXPECT_NEAR(sides->relative_l2, 0, 1e-6);
  EXPECT_FALSE(fit::side_onset(curve));

  curve = made(all[1], published(LoadingCase::die)); // pi^2 a^2/(144 (1 - x)^2) = 0.0593 at a = 1.2 x R
  for (auto& p : curve.points) p.side[0].contact_radius_m = 1.2 * p.delta_bar * curve.radius_m;
  const auto onset = fit::side_onset(curve);
  ASSERT_TRUE(onset);
  const double root = 12 * std::sqrt(0.0593) / std::numbers::pi; // 1.2 x = root (1 - x)
  EXPECT_NEAR(*onset, root / (1.2 + root), 5e-5);                // rows are 0.005 apart
}

TEST(AgarwalFit, SaysWhatACurveLacks) {
  const auto good = made(all[1], published(LoadingCase::die));
  auto curve = good;
  curve.experiment = "local";
  EXPECT_THROW(fit::fit_agarwal(curve), core::InvalidInput);
  curve = good;
  curve.E_Pa = 0;
  EXPECT_THROW(fit::fit_agarwal(curve), core::InvalidInput);
  curve = good;
  for (auto& p : curve.points) p.contact_radius_m = 0;
  EXPECT_THROW(fit::fit_agarwal(curve), core::InvalidInput);
  curve = good;
  curve.points.resize(12); // nothing to compare with
  EXPECT_THROW(fit::law_card(curve, fit::fit_agarwal(curve), "text"), core::InvalidInput);
  EXPECT_THROW(fit::fit_shahin(good), core::InvalidInput); // no inverse_m
}

TEST(ShahinFit, FindsTheCoefficientsThatMadeTheCurve) {
  for (const auto& loaded : all)
    for (const double inverse_m : {0.0, 0.5, 1.0})
      for (const bool other : {false, true}) {
        auto c = law::ShahinCoefficients<double>::published(loaded.loading, inverse_m,
                                                            law::ShahinVariant::hardening_minimum);
        const bool simple = loaded.loading == LoadingCase::simple;
        if (other) c.D1 *= 0.98, c.D3 *= 1.1, c.H_max *= 1.03;
        if (other && simple) c.q *= 0.9;
        if (other && !simple) c.x_min *= 0.95, c.H_min *= 1.05, c.L *= 1.1;
        auto curve = made(loaded, law::ShahinCurve<double>::make(loaded.loading, inverse_m, c));
        curve.inverse_m = inverse_m;
        const auto fit = fit::fit_shahin(curve);
        for (const auto& key : law::shahin_coefficients)
          EXPECT_NEAR(fit.fitted.*key.member / (c.*key.member), 1, 1e-3)
              << loaded.name << ' ' << inverse_m << ' ' << key.key;
        const auto card = fit::law_card(curve, fit, "text");
        const auto law = law::formulas<law::ShahinMaterial>({card.law, card.variant, card.parameters}, 0.01);
        const auto& p = curve.points[70];
        EXPECT_NEAR(law.loading(2 * p.delta_m).F, p.force_N, 1e-3 * p.force_N) << loaded.name << inverse_m;
      }
}

TEST(ShahinFit, LeavesAsPublishedWhatTheCurveDoesNotReach) {
  const auto c = law::ShahinCoefficients<double>::published(LoadingCase::die, 0.3,
                                                            law::ShahinVariant::hardening_minimum);
  auto curve = made(all[1], law::ShahinCurve<double>::make(LoadingCase::die, 0.3, c));
  curve.inverse_m = 0.3;
  curve.points.resize(50); // to 0.238, before pressure is least
  const std::vector<std::string_view> expected = {"D_3", "D_5", "q", "x_min", "H_min", "L"};
  EXPECT_EQ(fit::fit_shahin(curve).held, expected);
}
