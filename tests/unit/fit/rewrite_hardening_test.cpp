// One form of hardening written as another: where the answer is known, and what is refused.

#include "core/error.hpp"
#include "fit/rewrite_hardening.hpp"
#include "material/card.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace platen {
namespace {

using fit::rewrite_hardening;
using material::VonMises;

VonMises lead(const char* card) { return std::get<VonMises>(material::read_card(card).material.model); }

VonMises metal(material::Hardening hardening) { return {70e9, 0.33, 1e8, std::move(hardening)}; }

TEST(RewriteHardening, LudwiksLeadIsTheHollomonLawOfTheThesis) {
  // Shahin, text below eqs 2.2 and 2.3: the same lead as kappa = 20.5 MPa, m = 4.167.
  const auto out = rewrite_hardening(lead("lead-ludwik"), "hollomon", {0, 1.5});
  const auto& law = std::get<material::Hollomon>(out.material.hardening);
  EXPECT_NEAR(law.kappa, 20.5e6, 0.001 * 20.5e6);
  EXPECT_NEAR(1 / law.inverse_m, 4.167, 0.005 * 4.167);
  EXPECT_NEAR(out.relative_rms, 0.013, 0.0005); // docs/explanation/materials.md
  EXPECT_NEAR(out.worst, 0.42, 0.01);
  EXPECT_EQ(out.worst_at, 0);
}

TEST(RewriteHardening, FindsALawOfItsOwnKindAgain) {
  const auto ludwik = rewrite_hardening(metal(material::Ludwik{3e8, 0.4}), "ludwik", {0.01, 0.8});
  EXPECT_NEAR(std::get<material::Ludwik>(ludwik.material.hardening).K, 3e8, 1e3);
  EXPECT_NEAR(std::get<material::Ludwik>(ludwik.material.hardening).inverse_n, 0.4, 1e-6);
  EXPECT_NEAR(ludwik.material.sigma_y, 1e8, 1e3);
  EXPECT_LT(ludwik.worst, 1e-6);
  const auto hollomon = rewrite_hardening(metal(material::Hollomon{5e8, 0.2}), "hollomon", {0, 1});
  EXPECT_NEAR(std::get<material::Hollomon>(hollomon.material.hardening).kappa, 5e8, 1e2);
  EXPECT_NEAR(std::get<material::Hollomon>(hollomon.material.hardening).inverse_m, 0.2, 1e-6);
  for (const double eta : {-0.7, 1.5}) {
    const auto soft = rewrite_hardening(metal(material::ExponentialHardening{eta}), "exponential", {0, 1});
    EXPECT_NEAR(std::get<material::ExponentialHardening>(soft.material.hardening).eta, eta, 1e-6);
    EXPECT_NEAR(soft.material.sigma_y, 1e8, 1e3);
  }
}

TEST(RewriteHardening, NoLawOfTheKindIsNearer) {
  const VonMises given = lead("lead-ludwik");
  const auto out = rewrite_hardening(given, "hollomon", {0.05, 1});
  const auto best = std::get<material::Hollomon>(out.material.hardening);
  const auto misfit = [&](double kappa, double inverse_m) {
    double sum = 0;
    for (int i = 0; i < 1000; ++i) {
      const double strain = 0.05 + 0.95 * (i + 0.5) / 1000;
      const auto of = [&](const material::Hardening& h) {
        return yield_stress(h, given.E, given.sigma_y, strain).value;
      };
      sum += std::pow(of(material::Hollomon{kappa, inverse_m}) - of(given.hardening), 2);
    }
    return sum;
  };
  const double least = misfit(best.kappa, best.inverse_m);
  for (const double by : {-0.003, 0.003}) {
    EXPECT_GT(misfit(best.kappa * (1 + by), best.inverse_m), least) << by;
    EXPECT_GT(misfit(best.kappa, best.inverse_m * (1 + by)), least) << by;
  }
}

TEST(RewriteHardening, AsATableItIsTheSame) {
  for (const char* card : {"lead-ludwik", "lead-hollomon"})
    EXPECT_LT(rewrite_hardening(lead(card), "table", {0, 1}).worst, 0.001) << card;
}

TEST(RewriteHardening, PerfectlyPlasticHasTheMeanStress) {
  // The mean of exp(x) from 0 to 1 is e - 1.
  const auto out = rewrite_hardening(metal(material::ExponentialHardening{1}), "none", {0, 1});
  EXPECT_NEAR(out.material.sigma_y, 1e8 * (std::exp(1.0) - 1), 1e3);
}

TEST(RewriteHardening, WhatNoLawOfTheKindFollowsIsRefused) {
  const VonMises perfect = metal(material::PerfectlyPlastic{}),
                 softer = metal(material::ExponentialHardening{-0.5});
  for (const VonMises& m : {perfect, softer})
    for (const char* kind : {"hollomon", "ludwik"})
      EXPECT_THROW((void)rewrite_hardening(m, kind, {0, 1}), core::InvalidInput) << kind;
  EXPECT_THROW((void)rewrite_hardening(perfect, "holloman", {0, 1}), core::InvalidInput);
  for (const fit::StrainRange range : {fit::StrainRange{1, 0}, {0, 0}, {-1, 1}, {0, 200}, {0, NAN}, {NAN, 1}})
    EXPECT_THROW((void)rewrite_hardening(lead("lead-ludwik"), "hollomon", range), core::InvalidInput);
}

} // namespace
} // namespace platen
