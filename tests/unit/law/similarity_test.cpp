#include "platen/law/similarity.hpp"

#include "random_paths.hpp"

namespace {

using namespace platen::law;
using namespace platen::law::testing;

SimilarityMaterial material(double kappa, double inverse_m,
                            SimilarityVariant v = SimilarityVariant::published) {
  return {200e9, 0.3, kappa, inverse_m, v};
}

TEST(Similarity, PerfectPlasticityPressesWithThreeTimesTheYieldStress) { // Shahin (2.10)
  const auto law = prepare(material(100e6, 0), 1e-2);
  const Response r = evaluate(law, State{}, 1e-4);
  EXPECT_NEAR(r.mean_pressure, 3 * 100e6, 1e-3);
  EXPECT_NEAR(r.contact_radius, std::sqrt(2 * 1.43 * 1e-4 / (2 / 1e-2)), 1e-15); // (2.5)
}

TEST(Similarity, DissimilarSpheresFollowEquationTwoEight) {
  const double R1 = 3e-3, R2 = 8e-3, k1 = 50e6, k2 = 90e6, inverse_m = 0.25, gamma = 2e-5, m = 4;
  const auto law = prepare(material(k1, inverse_m), R1, material(k2, inverse_m), R2);
  const double A = 1 / R1 + 1 / R2, a = std::sqrt(2 * 1.43 * std::exp(-0.97 / m) * gamma / A);
  const double eta = std::numbers::pi * 3 * std::pow(6, -1 / m) * std::pow(A, 1 / m) *
                     std::pow(std::pow(k1, -m) + std::pow(k2, -m), -1 / m);
  const double F = eta * std::pow(a, 2 + 1 / m);
  EXPECT_NEAR(evaluate(law, State{}, gamma).force, F, 1e-12 * F);
}

TEST(Similarity, CurvatureCorrectionFollowsB24AndItsSeries) {
  const double R = 1e-2, A = 2 / R, B = 2 / (R * R * R), c2 = 1.43;
  const auto law = prepare(material(100e6, 0, SimilarityVariant::curvature_corrected), R);
  for (double x : {1e-3, 1e-2, 0.1, 0.4}) {
    const double gamma = 2 * R * x;
    const double a = std::sqrt(2 / B * (std::sqrt(A * A + 2 * B * c2 * gamma) - A));
    EXPECT_NEAR(law.loading(gamma).a, a, 1e-10 * a);
  }
  // erratum to (3.46)/(B.25): the Taylor series of (B.24)
  const double gamma = 2 * R * 1e-3, c = std::sqrt(c2);
  const double series = std::sqrt(2 * c2 * gamma / A) -
                        std::pow(2, -1.5) * c * c2 * B / std::pow(A, 2.5) * std::pow(gamma, 1.5) +
                        7 * std::pow(2, -4.5) * c * c2 * c2 * B * B / std::pow(A, 4.5) * std::pow(gamma, 2.5);
  EXPECT_NEAR(law.loading(gamma).a, series, 1e-7 * series);
}

TEST(Similarity, PlaneIsTheMirrorOfTwoEqualSpheres) {
  for (auto v : {SimilarityVariant::published, SimilarityVariant::curvature_corrected}) {
    const auto two = prepare(material(60e6, 0.4, v), 1e-3);
    const auto wall = prepare_on_rigid_plane(material(60e6, 0.4, v), 1e-3);
    for (double delta : {1e-7, 1e-5, 3e-4}) {
      const auto t = two.loading(2 * delta), w = wall.loading(delta);
      EXPECT_NEAR(t.F, w.F, 1e-12 * t.F);
      EXPECT_NEAR(t.a, w.a, 1e-12 * t.a);
      EXPECT_NEAR(two.work(2 * delta), 2 * wall.work(delta), 1e-12 * two.work(2 * delta));
    }
  }
}

TEST(Similarity, StrengthOfAPairIsSymmetricAndSoft) {
  EXPECT_EQ(similarity_strength(3, 5, 0.2), similarity_strength(5, 3, 0.2));
  EXPECT_EQ(similarity_strength(3, 5, 0), 3);
  EXPECT_NEAR(similarity_strength(3, 3, 0.5), 3 / std::sqrt(2), 1e-15);
  EXPECT_EQ(similarity_strength(3, infinity, 0.5), 3);
}

TEST(Similarity, SlopeAndWorkAreDerivativeAndIntegralOfTheForce) {
  for (auto v : {SimilarityVariant::published, SimilarityVariant::curvature_corrected}) {
    const auto law = prepare(material(60e6, 0.4, v), 1e-3);
    for (double g : {1e-8, 1e-5, 5e-4}) {
      const double h = 1e-5 * g;
      EXPECT_NEAR((law.loading(g + h).F - law.loading(g - h).F) / (2 * h) / law.loading(g).slope, 1, 1e-6);
      EXPECT_NEAR((law.work(g + h) - law.work(g - h)) / (2 * h) / law.loading(g).F, 1, 1e-6);
    }
  }
}

TEST(Similarity, RandomPathsCreateNothing) {
  for_random_cases(paths_per_law, [] {
    const auto v = static_cast<SimilarityVariant>(*rc::gen::inRange(0, 2));
    const double inverse_m = unit();
    const auto draw = [&] {
      const double kappa = log_between(1e5, 1e10);
      return SimilarityMaterial{kappa * log_between(3, 1e5), between(0, 0.49), kappa, inverse_m, v};
    };
    const SimilarityMaterial m1 = draw(), m2 = unit() < 0.5 ? m1 : draw();
    const double R1 = log_between(1e-6, 1e-1), R2 = unit() < 0.3   ? R1
                                                    : unit() < 0.3 ? infinity
                                                                   : R1 * log_between(0.05, 20);
    const auto law = prepare(m1, R1, m2, R2);
    holds_on_path(law, prepare(m2, R2, m1, R1), random_path(1 / law.pair.x_per_gamma));
  });
}

} // namespace
