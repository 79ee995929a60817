#include "core/error.hpp"
#include "core/file.hpp"
#include "surrogate/assess.hpp"
#include "surrogate/ripples.hpp"
#include "surrogate/said.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <numbers>

namespace platen::surrogate {
namespace {

/// A metal as the curve of a formula has it: F_bar over lambda = E/((1 - nu^2) sigma_y), `factor` times.
Pressed metal(double E_bar, double factor, const PoolData& data) {
  Pressed run;
  run.description = describe(material::VonMises{E_bar, 0.3, 1});
  const double lambda = std::exp(run.description.coordinates[0]);
  for (const double x : data.knots) {
    const double elastic = 4 / (3 * std::numbers::pi) * lambda * std::pow(x, 1.5), plastic = 6 * x;
    run.F_bar.push_back(factor * elastic * plastic / (elastic + plastic));
    run.a_bar.push_back(std::sqrt(2 * x) * plastic / (elastic + plastic) + std::sqrt(x));
  }
  for (std::size_t b = 0; b < data.unload_delta_bar.size(); ++b) {
    const double at = data.unload_delta_bar[b], F = run.F_bar[b == 0 ? 3 : 5];
    run.alpha.push_back(1.5 - 0.1 * std::log10(lambda));
    run.beta.push_back(1 + at);
    const double returned = std::pow(0.75 * std::numbers::pi * F / lambda, 2.0 / 3) / run.beta.back();
    run.residual.push_back(at - returned);
    run.branches.push_back(
        {{at - returned, at}, {0, 2 * F / (run.alpha.back() + 1)}}); // the work of the power law
    run.returned.push_back(returned_of(run.branches.back(), run.description));
  }
  return run;
}

PoolData metals(double factor = 1, double from = 20, double to = 2000, int count = 15) {
  PoolData data;
  data.name = "metals";
  data.engine = 6;
  data.elements = ripple_free_elements;
  data.asked = static_cast<std::size_t>(count);
  data.knots = {0.002, 0.01, 0.05, 0.1, 0.3, 0.5};
  data.unload_delta_bar = {0.1, 0.5};
  for (int i = 0; i < count; ++i) {
    data.runs.push_back(metal(from * std::pow(to / from, i / (count - 1.0)), factor, data));
    data.runs.back().run = i + 1;
    data.runs.back().pool = data.name;
  }
  return data;
}

double worst(const std::vector<double>& said, const std::vector<double>& truth) {
  double most = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) most = std::max(most, std::abs(said[i] / truth[i] - 1));
  return most;
}

/// A file of this process alone, gone with the test.
struct Scratch {
  std::filesystem::path file =
      std::filesystem::path(::testing::TempDir()) / fmt::format("platen-surrogate-{}.txt", ::getpid());
  ~Scratch() { std::filesystem::remove(file); }
};

TEST(Surrogate, SaysCurvesBetweenThoseOfItsPool) {
  const auto data = metals();
  const auto s = fit_surrogate({data});
  const Pressed truth = metal(130, 1, data);
  const Prediction p = predict(s, truth.description);
  EXPECT_LT(worst(p.F_bar, truth.F_bar), 2e-3);
  EXPECT_LT(worst(p.a_bar, truth.a_bar), 2e-3);
  EXPECT_LT(worst(p.alpha, truth.alpha), 2e-3);
  EXPECT_LT(worst(p.beta, truth.beta), 2e-3);
  EXPECT_EQ(assess(s, truth.description, p).verdict, Verdict::inside);
}

// A curve as powers have it, with and without the ripples of a contact that grows by elements.
TEST(Ripples, AreSmoothedAndBendsStay) {
  std::vector<double> knots, curve, rippled;
  for (int i = 0; i < 50; ++i) {
    knots.push_back(0.01 * (i + 1));
    curve.push_back(1.5 * std::log(knots.back()) + 2 * knots.back() * knots.back());
    rippled.push_back(curve.back() + 0.04 * std::sin(2 * std::numbers::pi * knots.back() / 0.05));
  }
  const auto still = without_ripples(knots, curve), calm = without_ripples(knots, rippled);
  for (std::size_t i = 3; i + 3 < knots.size(); ++i) {
    EXPECT_NEAR(still[i], curve[i], 0.004) << knots[i];
    EXPECT_NEAR(calm[i], curve[i], 0.02) << knots[i];
  }
}

TEST(Surrogate, DoesNotDependOnUnits) {
  const auto a = describe(material::VonMises{2e9, 0.3, 2e7}), b = describe(material::VonMises{100, 0.3, 1});
  EXPECT_NEAR(a.coordinates[0], b.coordinates[0], 1e-12);
}

TEST(Surrogate, IsTheSameFromItsFile) {
  const Scratch scratch;
  const auto s = fit_surrogate({metals()});
  core::write_file(scratch.file, text_of(s));
  const auto again = read_surrogate(scratch.file);
  const auto d = describe(material::VonMises{77, 0.3, 1});
  EXPECT_EQ(predict(s, d).F_bar, predict(again, d).F_bar);
  EXPECT_EQ(predict(s, d).band, predict(again, d).band);
  EXPECT_EQ(predict(s, d).beta, predict(again, d).beta);
  EXPECT_EQ(text_of(s), text_of(again));
}

TEST(Surrogate, RefusesADamagedFile) {
  const Scratch scratch;
  const std::string text = text_of(fit_surrogate({metals()}));
  for (const std::string& bad :
       {std::string("something else"), std::string(), text.substr(0, text.size() / 2),
        std::string("platen-surrogate 0") + text.substr(18)}) {
    core::write_file(scratch.file, bad);
    EXPECT_THROW((void)read_surrogate(scratch.file), core::InvalidInput) << bad.substr(0, 40);
  }
}

// Few fine presses beside many coarse ones that are all a little off.
TEST(Surrogate, CorrectsCoarsePressesByFineOnes) {
  const auto coarse = metals(1.03);
  auto fine = metals();
  fine.runs = {fine.runs[0], fine.runs[3], fine.runs[7], fine.runs[11], fine.runs[14]};
  const auto s = fit_surrogate({fine, &coarse});
  const Pressed truth = metal(130, 1, fine);
  EXPECT_LT(worst(predict(s, truth.description).F_bar, truth.F_bar), 3e-3);
  EXPECT_EQ(s.layers.size(), 2U);
  EXPECT_EQ(s.fine, 5);
}

TEST(Surrogate, RefusesCoarsePressesOfSomethingElse) {
  const auto fine = metals(), coarse = metals(1, 30, 3000);
  EXPECT_THROW((void)fit_surrogate({fine, &coarse}), core::InvalidInput);
}

TEST(Surrogate, TakesTheForceBetweenKnots) {
  const std::vector<double> knots = {0.1, 0.2, 0.4}, ln_F = {0, 1, 3};
  EXPECT_EQ(at_overlap(0.2, knots, ln_F), 1);
  EXPECT_NEAR(at_overlap(0.2 * std::sqrt(2), knots, ln_F), 2, 1e-12);
  EXPECT_EQ(at_overlap(0.05, knots, ln_F), 0); // not beyond
  EXPECT_EQ(at_overlap(0.5, knots, ln_F), 3);
  EXPECT_NEAR(over_force({7}, {0.4}, knots, ln_F)[0], 2, 1e-12); // less 5/3 of ln F
}

TEST(Surrogate, SaysWhenAMaterialIsOutside) {
  const auto s = fit_surrogate({metals()});
  const auto judged = [&](double E_bar, double nu) {
    const auto d = describe(material::VonMises{E_bar, nu, 1});
    return assess(s, d, predict(s, d));
  };
  EXPECT_EQ(judged(100, 0.3).verdict, Verdict::inside);
  EXPECT_EQ(judged(20, 0.3).verdict, Verdict::inside);
  EXPECT_EQ(judged(100, 0.2).verdict, Verdict::outside);
  EXPECT_EQ(judged(100, 0.48).verdict, Verdict::outside);
  const auto beyond = judged(3000, 0.3);
  EXPECT_EQ(beyond.verdict, Verdict::outside);
  EXPECT_NE(beyond.reasons.front().find("E_bar = 3000 is not in 20 to 2000"), std::string::npos);
}

// Knots at 0.002, 0.01, 0.05, 0.1, 0.3, 0.5.
TEST(Surrogate, LetsALawEndWhereItIsNoLongerCertain) {
  const auto s = fit_surrogate({metals()});
  const auto d = describe(material::VonMises{130, 0.3, 1});
  Prediction p = predict(s, d);
  p.expected = {0.01, 0.01, 0.01, 0.02, 0.02, 0.025};
  EXPECT_EQ(assess(s, d, p).verdict, Verdict::inside);
  p.expected.back() = 0.05;
  EXPECT_EQ(assess(s, d, p).verdict, Verdict::near_the_edge);
  EXPECT_EQ(assess(s, d, p).knots, 6U);
  p.expected.back() = 0.4;
  const auto a = assess(s, d, p);
  EXPECT_EQ(a.verdict, Verdict::near_the_edge);
  EXPECT_EQ(a.knots, 5U);
  EXPECT_NE(a.reasons.back().find("the law ends at delta/R0 = 0.3"), std::string::npos) << a.reasons.back();
  p.expected[3] = p.expected[4] = 0.2;
  EXPECT_EQ(assess(s, d, p).verdict, Verdict::outside);
}

TEST(Surrogate, NamesTheNearestMaterials) {
  const auto s = fit_surrogate({metals(1, 20, 2000, 5)}); // 20, 63.2, 200, 632, 2000
  const auto near = nearest(s, describe(material::VonMises{190, 0.3, 1}), 2);
  ASSERT_EQ(near.size(), 2U);
  EXPECT_EQ(words(s, near[0]), "metals-3: E_bar = 200");
  EXPECT_EQ(s.runs[near[1].index], "metals-2");
}

// Hollomon's law has a yield stress of its own, kappa (kappa/E)^(m'/(1 - m')), m' = 1/m.
TEST(Surrogate, SeesTheFlowStressOfAMetalThatHardens) {
  const auto hollomon = describe(material::VonMises{1e9, 0.3, 0, material::Hollomon{1e7, 0.5}});
  EXPECT_NEAR(hollomon.sigma_ref, 1e5, 1e-3);
  EXPECT_NEAR(hollomon.numbers[0].value, 1e4, 1e-3);
  material::HardeningTable table({0, 0.1, 0.5, 5}, {1e7, 1.5e7, 2e7, 2e7});
  const auto d = describe(material::VonMises{1e9, 0.3, 0, table});
  EXPECT_EQ(d.model, "von-mises-hardening");
  EXPECT_NEAR(d.numbers[2].value, 1.5, 1e-12);
  EXPECT_NEAR(d.numbers[3].value, 2, 1e-12);
  EXPECT_NEAR(d.coordinates[3], std::log(1.625), 1e-12) << "at 0.2";
}

TEST(Surrogate, HasNoPoolOfRock) {
  EXPECT_THROW((void)describe(material::DruckerPrager{}), core::InvalidInput);
}

} // namespace
} // namespace platen::surrogate
