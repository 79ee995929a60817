// The fit of wang to curves made from its own formulas.

#include "fit/wang.hpp"

#include "core/error.hpp"
#include "platen/law/wang.hpp"
#include "press/curve_csv.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace platen;

namespace {

struct Made {
  press::Curve curve;
  double F_y, delta_y;
};

/// F/F_y = a omega^b up to omega = 8, unloaded along m (omega - omega_res)^n. hertz_delta_m is the law's
/// overlap; delta_m is another, which must not matter.
Made made(double a, double b, double omega_res, double n) {
  Made result;
  press::Curve& curve = result.curve;
  curve.radius_m = 0.1;
  curve.E_Pa = 10e9;
  curve.nu = 0.15;
  curve.sigma_ref_Pa = curve.sigma_c_Pa = 15e6;
  curve.phi_deg = 25;
  curve.experiment = "local";
  const auto law = law::prepare_on_rigid_plane(law::WangMaterial{10e9, 0.15, 25, 15e6}, 0.1);
  result.F_y = law.F_y;
  result.delta_y = law.gamma_y;
  const double omega_max = 8, F_max = a * std::pow(omega_max, b);
  const auto add = [&](press::Branch branch, double omega, double F_over_F_y) {
    press::CurvePoint point;
    point.branch = branch;
    point.branch_id = branch == press::Branch::loading ? 0 : 1;
    point.hertz_delta_m = omega * law.gamma_y;
    point.delta_m = 0.99 * point.hertz_delta_m;
    point.force_N = F_over_F_y * law.F_y;
    curve.points.push_back(point);
  };
  for (double omega = 0.5; omega <= omega_max; omega += 0.25)
    add(press::Branch::loading, omega, a * std::pow(omega, b));
  for (int i = 0; i < 30; ++i) {
    const double omega = omega_max - (omega_max - omega_res) * i / 30;
    add(press::Branch::unloading, omega, F_max * std::pow((omega - omega_res) / (omega_max - omega_res), n));
  }
  for (auto& point : curve.points) point.delta_bar = point.delta_m / curve.radius_m;
  press::set_reference_stress(curve, curve.sigma_ref_Pa);
  return result;
}

} // namespace

TEST(WangFit, FindsTheParametersThatMadeTheCurve) {
  const Made m = made(1.02, 1.43, 0.6, 1.38);
  const auto fit = fit::fit_wang(m.curve);
  EXPECT_NEAR(fit.F_y_N, m.F_y, 1e-9 * m.F_y);
  EXPECT_NEAR(fit.delta_y_m, m.delta_y, 1e-9 * m.delta_y);
  EXPECT_NEAR(fit.a, 1.02, 1e-6);
  EXPECT_NEAR(fit.b, 1.43, 1e-6);
  EXPECT_GT(fit.r_squared, 1 - 1e-10);
  ASSERT_EQ(fit.unloading.size(), 1u);
  const auto& u = fit.unloading.front();
  EXPECT_NEAR(u.n, 1.38, 1e-4);
  EXPECT_NEAR(u.delta_res_m / m.delta_y, 0.6, 1e-3);
  const double made_m = 1.02 * std::pow(8, 1.43) / std::pow(7.4, 1.38);
  EXPECT_NEAR(u.m, made_m, 1e-3);
  EXPECT_NEAR(fit.n, 1.38, 1e-3); // one branch alone says the same
  EXPECT_NEAR(fit.m, made_m, 3e-3);
  for (const auto& form : fit.others) EXPECT_LT(form.r_squared, fit.r_squared) << form.name;
}

TEST(WangFit, FindsOneUnloadingLawForSeveralBranches) {
  Made made_curve = made(1.02, 1.43, 0.6, 1.38);
  const double made_m = 1.02 * std::pow(8, 1.43) / std::pow(7.4, 1.38);
  // A second branch of the same m and n, from omega = 4.
  const double F_max = 1.02 * std::pow(4, 1.43), range = std::pow(F_max / made_m, 1 / 1.38);
  for (int i = 0; i < 30; ++i) {
    press::CurvePoint point;
    point.branch = press::Branch::unloading;
    point.branch_id = 2;
    const double left = 1 - i / 30.0;
    point.hertz_delta_m = (4 - range + range * left) * made_curve.delta_y;
    point.delta_m = 0.99 * point.hertz_delta_m;
    point.delta_bar = point.delta_m / made_curve.curve.radius_m;
    point.force_N = F_max * std::pow(left, 1.38) * made_curve.F_y;
    made_curve.curve.points.push_back(point);
  }
  press::set_reference_stress(made_curve.curve, 15e6);
  const auto fit = fit::fit_wang(made_curve.curve);
  ASSERT_EQ(fit.unloading.size(), 2u);
  EXPECT_NEAR(fit.n, 1.38, 1e-4);
  EXPECT_NEAR(fit.m, made_m, 1e-3);
  EXPECT_GT(fit.unloading_r_squared, 1 - 1e-8);
}

TEST(WangFit, MakesACardThatReadsBackAsTheLaw) {
  const Made m = made(1.02, 1.43, 0.6, 1.38);
  const auto card = fit::law_card(m.curve, fit::fit_wang(m.curve), "text");
  EXPECT_EQ(card.variant, "fitted");
  const auto law = law::formulas_on_plane<law::WangMaterial>({card.law, card.variant, card.parameters}, 0.1);
  EXPECT_NEAR(law.loading(4 * m.delta_y).F, m.F_y * 1.02 * std::pow(4, 1.43), 1e-4 * m.F_y);
}

TEST(WangFit, SaysWhatFewPointsBeyondYieldCan) {
  for (const std::size_t points : {3, 4, 7}) {
    Made m = made(1.02, 1.43, 0.6, 1.38);
    m.curve.points.resize(points + 3); // from 0.5 on in steps of 0.25: three up to yield
    const auto fit = fit::fit_wang(m.curve);
    EXPECT_EQ(fit.points, points);
    EXPECT_NEAR(fit.a, 1.02, 1e-6);
    EXPECT_NEAR(fit.b, 1.43, 1e-6);
    ASSERT_EQ(fit.notes.size(), 1u);
    const auto card = fit::law_card(m.curve, fit, "text");
    EXPECT_EQ(card.variant, "generic");
    EXPECT_EQ(fit::value_of(card.provenance, "caveat"), core::FieldValue(fit.caveat));
    EXPECT_LE(fit.others.size(), 3u);
  }
  EXPECT_TRUE(fit::fit_wang(made(1.02, 1.43, 0.6, 1.38).curve).caveat.empty());
  Made m = made(1, 1.45, 0.6, 1.38); // two, and first yield itself
  m.curve.points.resize(5);
  const auto fit = fit::fit_wang(m.curve);
  EXPECT_EQ(fit.points, 2u);
  EXPECT_NEAR(fit.a, 1, 1e-6);
  EXPECT_NEAR(fit.b, 1.45, 1e-6);
  EXPECT_NE(fit.caveat.find("first yield itself"), std::string::npos);
  m.curve.points.resize(4);
  EXPECT_THROW(fit::fit_wang(m.curve), core::InvalidInput);
}

TEST(WangFit, CardHoldsOutsideTheMaterialsOfTable1) { // which are those of the coefficients of Table 2
  Made m = made(1.02, 1.43, 0.6, 1.38);
  auto card = fit::law_card(m.curve, fit::fit_wang(m.curve), "text");
  card.parameters["E_Pa"] = "40e9";
  const auto law = fit::make_law(card, {{"radius_m", "0.1"}, {"against", "plane"}});
  EXPECT_TRUE(law::evaluate(law, {}, m.delta_y).in_range);
}

TEST(WangFit, SaysWhatACurveLacks) {
  Made m = made(1, 1.5, 0.5, 1.5);
  m.curve.sigma_c_Pa = 0;
  EXPECT_THROW(fit::fit_wang(m.curve), core::InvalidInput);
  m = made(1, 1.5, 0.5, 1.5);
  m.curve.points.resize(4);
  EXPECT_THROW(fit::fit_wang(m.curve), core::InvalidInput);
}
