// Regimes of curves made from formulas, whose boundaries are known.

#include "press/regimes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace platen;

namespace {

/// Rows in even steps of ln delta_bar from 1e-3 to `end`. Dissipation begins at 0.002: its share of the work
/// rises as 0.5 (1 - 0.002/x). Pressure is 3 - 2 ln(x/0.02)^2/10 up to x = 0.1, from there the parabola that
/// joins it smoothly and is least at `least_at`; `scallops` of that share are laid over it.
press::Curve made(double end, double least_at, double scallops, double stored_rate_at_end = 0.2) {
  press::Curve curve;
  curve.radius_m = curve.sigma_ref_Pa = 1;
  double stored = 0, last_work = 0;
  const double join = 0.1, p_join = 3 - 0.2 * std::pow(std::log(join / 0.02), 2);
  const double slope = -0.4 * std::log(join / 0.02) / join;
  const double bend = -slope / (2 * (least_at - join));
  constexpr int rows = 120;
  for (int i = 0; i <= rows; ++i) {
    press::CurvePoint p;
    const double x = p.delta_bar = 1e-3 * std::pow(end / 1e-3, double(i) / rows);
    p.mean_pressure_Pa = x < join ? 3 - 0.2 * std::pow(std::log(x / 0.02), 2)
                                  : p_join + slope * (x - join) + bend * std::pow(x - join, 2);
    p.mean_pressure_Pa *= 1 + scallops * std::sin(2 * std::numbers::pi * std::log(x) / 0.2);
    p.work_J = x * x;
    p.dissipated_J = x > 0.002 ? 0.5 * (1 - 0.002 / x) * p.work_J : 0;
    const double rate = x < least_at ? 0 : stored_rate_at_end * (x - least_at) / (end - least_at);
    stored += rate * (p.work_J - last_work);
    last_work = p.work_J;
    p.stored_J = stored;
    curve.points.push_back(p);
  }
  return curve;
}

} // namespace

TEST(Regimes, AreFoundWhereTheyWerePut) {
  for (const double scallops : {0.0, 0.03}) {
    const auto found = press::regimes(made(0.3, 0.2, scallops, 0.8));
    ASSERT_TRUE(found.elastic_plastic && found.plastic && found.low_compressibility &&
                found.elastic_volumetric);
    EXPECT_NEAR(*found.elastic_plastic, 0.002, 0.00005); // to a row
    EXPECT_NEAR(*found.plastic, 0.02, scallops > 0 ? 0.006 : 0.001);
    EXPECT_NEAR(*found.low_compressibility, 0.2, scallops > 0 ? 0.015 : 0.006);
    EXPECT_NEAR(*found.elastic_volumetric, 0.2 + 0.1 * 0.5 / 0.8, 0.01);
    EXPECT_NEAR(*found.stored_share_at_end, 0.8, 0.05);
  }
}

TEST(Regimes, AreNotFoundWhereThereAreNone) {
  auto curve = made(0.2, 0.25, 0.03); // pressure falls to the end
  auto found = press::regimes(curve);
  EXPECT_TRUE(found.plastic);
  EXPECT_FALSE(found.low_compressibility);
  EXPECT_FALSE(found.elastic_volumetric);
  found = press::regimes(made(0.3, 0.2, 0, 0.2)); // too little is stored
  EXPECT_TRUE(found.low_compressibility);
  EXPECT_FALSE(found.elastic_volumetric);
  curve = made(0.015, 0.25, 0.03); // ends before pressure is largest
  EXPECT_FALSE(press::regimes(curve).plastic);
  for (auto& p : curve.points) p.dissipated_J = 0, p.stored_J = p.work_J;
  found = press::regimes(curve);
  EXPECT_FALSE(found.elastic_plastic || found.plastic || found.low_compressibility ||
               found.elastic_volumetric);
  EXPECT_NEAR(*found.stored_share_at_end, 1, 1e-9);
  EXPECT_FALSE(press::regimes({}).stored_share_at_end);
}

TEST(Regimes, AreTold) {
  const auto words = press::regimes_words(press::regimes(made(0.2, 0.25, 0)));
  EXPECT_NE(words.find("elastic-plastic      from 0.00195"), std::string::npos) << words;
  EXPECT_NE(words.find("low compressibility  not reached"), std::string::npos) << words;
  auto curve = made(0.2, 0.25, 0);
  curve.points.erase(curve.points.begin(), curve.points.begin() + 30);
  EXPECT_NE(press::regimes_words(press::regimes(curve)).find("from at most"), std::string::npos);
}
