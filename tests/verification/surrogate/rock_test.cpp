// Rock: natural neighbours between the 162 grains of Wang et al., Table 1, against their Table 4 and beside
// other ways; what docs/explanation/surrogate.md and predict.md claim of them.

#include "surrogate/rock.hpp"

#include "core/error.hpp"
#include "fit/wang.hpp"
#include "material/card.hpp"
#include "press/curve_csv.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace platen::surrogate {
namespace {

const std::filesystem::path catalogue = std::filesystem::path(PLATEN_SOURCE_DIR) / "catalogue";

Rock shipped() { return read_rock(catalogue / "pools/wang/grains.csv"); }

/// Relative errors in the paper's convention, delta of both spheres over delta_y of one.
Coefficients errors(const Coefficients& said, const Coefficients& truth) {
  const auto theirs = [](const Coefficients& c) {
    return Coefficients{c[0] / std::exp2(c[1]), c[1], c[2] / std::exp2(c[3]), c[3]};
  };
  const auto one = theirs(said), other = theirs(truth);
  Coefficients e{};
  for (std::size_t k = 0; k < 4; ++k) e[k] = std::abs(one[k] / other[k] - 1);
  return e;
}

// Table 4: errors of their interpolation, of the grains of Table 3, which are none of the 162.
TEST(Rock, IsPredictedNotWorseThanTable4) {
  const Rock rock = shipped();
  const RockInterpolation interpolation(rock);
  const auto one = interpolation.at({0, 1e10, 0.15, 25, 15e6, {}});
  const auto two = interpolation.at({0, 1e10, 0.25, 35, 25e6, {}});
  ASSERT_TRUE(one && two);
  const auto pressed =
      fit::fit_wang(press::read_curve((catalogue / "papers/presses/wang-type-1/curve.csv").string()));
  const auto first = errors(*one, {pressed.a, pressed.b, pressed.m, pressed.n});
  const auto second = errors(*two, {1, 1.5, 1, 1.5}); // elastic, as they say
  const Coefficients table_4_first = {0.0192, 0.0050, 0.0931, 0.0075},
                     table_4_second = {0.0009, 0.0010, 0.0120, 0.0016};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_LT(first[k], table_4_first[k]) << coefficient_names[k];
    EXPECT_LT(second[k], table_4_second[k]) << coefficient_names[k];
  }
}

// Thirty grains at random from the ranges of the 162.
TEST(Rock, SaysFreshGrains) {
  const auto e = errors_beside(shipped(), rock_of_pool(catalogue / "pools/fresh-wang"));
  ASSERT_EQ(e.materials, 30);
  EXPECT_LT(e.of[2].p95, 0.025); // m
  EXPECT_LT(e.of[3].worst, 0.01);
  EXPECT_LT(e.force.median, 0.0005);
  EXPECT_LT(e.force.worst, 0.01);
  EXPECT_LT(e.work.worst, 0.012);
}

TEST(Rock, RefusesGrainsPressedOtherwise) {
  Rock other = shipped();
  other.force_N *= 2;
  EXPECT_THROW(errors_beside(shipped(), other), core::InvalidInput);
}

TEST(Rock, IsMadeAgainFromItsPool) {
  const Rock again = rock_of_pool(catalogue / "pools/wang"), file = shipped();
  EXPECT_EQ(text_of(again), text_of(file));
  EXPECT_EQ(file.grains.size(), 162U);
}

// The ways of the paper, beside: each grain without itself.
TEST(Rock, IsBestPredictedOverFirstYield) {
  const auto methods = rock_methods(shipped());
  const auto figures = [&](const std::string& name) {
    for (const auto& m : methods)
      if (m.name == name) return m.errors;
    ADD_FAILURE() << name;
    return RockErrors{};
  };
  const auto printed = figures("regression (19) as printed"), refitted = figures("regression (19), refitted"),
             theirs = figures("natural neighbours, E, nu, phi, sigma_c"),
             ours = figures("natural neighbours, nu, phi, ln F_y"),
             process = figures("Gaussian process, nu, phi, ln F_y");
  EXPECT_GT(printed.force.median, 0.01);
  EXPECT_GT(printed.of[2].median, 0.25);
  EXPECT_GT(refitted.work.p95, 1);
  EXPECT_LT(theirs.force.p95, 0.025);
  EXPECT_LT(ours.force.median, 0.001);
  EXPECT_LT(ours.force.p95, 0.005);
  EXPECT_LT(ours.force.worst, 0.05);
  EXPECT_LT(ours.work.p95, 0.015);
  EXPECT_LT(ours.of[2].p95, 0.04);
  EXPECT_LT(process.force.worst, 0.01);
  EXPECT_LT(process.work.p95, 0.01);
}

// Sites of natural neighbours.
TEST(Rock, IsExactAtTheGrains) {
  const Rock rock = shipped();
  const RockInterpolation interpolation(rock);
  for (const Grain& g : rock.grains) {
    const auto said = interpolation.at(g);
    ASSERT_TRUE(said);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR((*said)[k], g.of[k], 1e-12);
  }
}

material::Material rock_material(double E, double nu, double phi_deg, double sigma_c) {
  const double beta = material::DruckerPrager::beta_of_friction(phi_deg);
  material::Material m;
  m.name = "a rock";
  m.model = material::DruckerPrager{E, nu, beta, sigma_c, beta};
  return m;
}

TEST(PredictRock, SaysWhatIsKnownOfIt) {
  const auto inside = predict_rock(rock_material(1.5e10, 0.2, 30, 2e7), "card.toml");
  EXPECT_EQ(inside.verdict, Verdict::inside);
  EXPECT_EQ(inside.near.size(), 3U);
  EXPECT_EQ(inside.card.law, "wang");
  // E and sigma_c beyond the table, first yield within: similar to grains that were pressed
  const auto soft = predict_rock(rock_material(5e9, 0.2, 30, 6e6), "card.toml");
  EXPECT_EQ(soft.verdict, Verdict::near_the_edge);
  // yields far beyond the force: elastic
  const auto strong = predict_rock(rock_material(1e10, 0.2, 30, 3e8), "card.toml");
  EXPECT_EQ(strong.of, (Coefficients{1, 1.5, 1, 1.5}));
  EXPECT_EQ(strong.verdict, Verdict::near_the_edge);
  EXPECT_THROW(predict_rock(rock_material(1e10, 0.4, 30, 2e7), "card.toml"), core::InvalidInput);
  EXPECT_THROW(predict_rock(rock_material(1e10, 0.2, 45, 2e7), "card.toml"), core::InvalidInput);
  EXPECT_THROW(predict_rock(rock_material(1e10, 0.2, 30, 1e6), "card.toml"),
               core::InvalidInput); // yields too early
}

} // namespace
} // namespace platen::surrogate
