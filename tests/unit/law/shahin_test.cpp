#include "platen/law/shahin.hpp"

#include "random_paths.hpp"

#include <random>

namespace {

using namespace platen::law;
using namespace platen::law::testing;

using Curve = ShahinCurve<double>;
constexpr auto all_cases = {LoadingCase::simple, LoadingCase::die, LoadingCase::hydrostatic};

ShahinMaterial material(double inverse_m, LoadingCase loading) {
  return {200e9, 0.3, 100e6, inverse_m, loading};
}

TEST(Shahin,
     WithoutHardeningItIsTheRigidPlasticLimitOfChapterTwo) { // (3.41) against (2.48), lambda -> infinity
  for (LoadingCase loading : all_cases) {
    const Curve rigid = Curve::make(loading, 0.0);
    const auto elastic = AgarwalCurve<double>::make(loading, AgarwalVariant::published, 1e14, 1e14);
    EXPECT_NEAR(rigid.H_max, 3.101, 1e-12);
    EXPECT_NEAR(rigid.x_min, elastic.x_min, 1e-6);
    EXPECT_NEAR(rigid.H_min, elastic.H_min, 1e-3);
    for (double x : {0.02, 0.05, 0.1, 0.14})
      EXPECT_NEAR(rigid.at(x).H, elastic.at(x).H, 2e-3) << int(loading);
    if (loading != LoadingCase::simple) { // and (3.40) is the limit zeta -> infinity of (2.41)
      const double x = 0.9 * x_of_filled_cell(loading);
      EXPECT_NEAR(rigid.at(x).H, elastic.at(x).H, 2e-3);
    }
  }
}

TEST(Shahin,
     LeastPressureFromEitherRadius) { // docs/laws/shahin.md, die, 1/m = 1, x = 0.45: H_bar = 1.615 or 1.192
  EXPECT_NEAR(Curve::make(LoadingCase::die, 1.0, ShahinVariant::published).at(0.45).H, 1.615, 0.0005);
  EXPECT_NEAR(Curve::make(LoadingCase::die, 1.0, ShahinVariant::hardening_minimum).at(0.45).H, 1.192, 0.0005);
}

TEST(Shahin,
     PressureStaysPositiveWhereThePrintedFormDoesNot) { // docs/laws/shahin.md: simple, 1/m = 0.5, x = 0.2:
                                                        // printed -0.11
  const Curve c = Curve::make(LoadingCase::simple, 0.5);
  EXPECT_GT(c.at(0.2).H, 0.5);
  // printed: p = 3.101 - 1 under H_max e^(-1.748/m)
  const double q = 14.1819, s = 1 - std::atan(2 * q / std::sinh(2 * q));
  const double printed =
      (3.101 * std::exp(-1.748 * 0.5) - 2.101 * std::tanh(q * 0.2) * std::cos(0.2 - s)) * std::pow(0.2, 0.25);
  EXPECT_NEAR(printed, -0.11, 0.005);
  for (LoadingCase loading : all_cases)
    for (double inverse_m = 0; inverse_m <= 1; inverse_m += 0.05) {
      const Curve any = Curve::make(loading, inverse_m);
      for (double x = 1e-6; x < (loading == LoadingCase::simple ? 0.6 : 0.99 * x_of_filled_cell(loading));
           x *= 1.05) {
        EXPECT_GT(any.at(x).H, 0) << inverse_m << ' ' << x;
        EXPECT_GT(any.at(x).slope, 0) << inverse_m << ' ' << x;
      }
    }
}

TEST(Shahin, RegimesJoinWithoutStepOrKink) {
  std::mt19937_64 random(20261122);
  std::uniform_real_distribution<double> u(0, 1);
  for (LoadingCase loading : {LoadingCase::die, LoadingCase::hydrostatic})
    for (int i = 0; i < 1000; ++i) {
      const Curve c = Curve::make(loading, u(random), static_cast<ShahinVariant>(i % 2));
      double H1, H2, s1, s2;
      c.plastic(c.x_min, H1, s1), c.low_compressibility(c.x_min, H2, s2);
      EXPECT_NEAR(H1, H2, 1e-12 * H1);
      EXPECT_NEAR(s1, s2, 1e-9);
    }
}

TEST(Shahin, StiffnessIsTheDerivativeOfTheForce) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> u(0, 1);
  for (LoadingCase loading : all_cases)
    for (int i = 0; i < 1000; ++i) {
      const Curve c = Curve::make(loading, u(random));
      const double end = loading == LoadingCase::simple ? 0.55 : 0.98 * x_of_filled_cell(loading);
      const double x = end * std::pow(1e-6, u(random)), h = 1e-4 * x;
      if (std::abs(x - c.x_min) < 0.01 * c.x_min) continue;
      const double d =
          (8 * (c.F_bar(x + h) - c.F_bar(x - h)) - (c.F_bar(x + 2 * h) - c.F_bar(x - 2 * h))) / (12 * h);
      EXPECT_NEAR(d, c.at(x).slope, 1e-6 * c.at(x).slope) << c.inverse_m << ' ' << x;
    }
}

TEST(Shahin, TablesFollowTheFormulasToOneInTenThousand) {
  double worst = 0;
  for (LoadingCase loading : all_cases)
    for (double inverse_m = 0; inverse_m <= 1; inverse_m += 0.05) {
      const Shahin law = prepare(material(inverse_m, loading), 1e-3);
      for (double x = 2 * Shahin::x_table; x < law.x_cap; x *= 1.002) {
        Loading<double> here;
        law.force(x, here);
        worst = std::max(worst, std::abs(here.F / law.curve.F_bar(x) - 1));
      }
    }
  RecordProperty("worst", std::to_string(worst));
  EXPECT_LE(worst, 1e-4);
}

TEST(Shahin, TabledCurveIsContinuousAtItsOwnJoints) {
  for (LoadingCase loading : all_cases) {
    const Shahin law = prepare(material(0.3, loading), 1e-3);
    for (double joint : {law.plastic.x_low(), law.plastic.x_high(), law.x_cap}) {
      Loading<double> one, two;
      law.force(joint * (1 - 1e-15), one), law.force(joint * (1 + 1e-15), two);
      const double F1 = one.F, s1 = one.slope, F2 = two.F, s2 = two.slope;
      EXPECT_NEAR(F1, F2, 1e-12 * F1 + 4e-15 * joint * s1)
          << joint; // the second term: x itself moves by 2e-15
      EXPECT_NEAR(s1, s2, 1e-9 * s1) << joint;
    }
  }
}

TEST(Shahin, WorkIsTheIntegralOfTheForce) {
  for (LoadingCase loading : all_cases) {
    const Shahin law = prepare(material(0.3, loading), 1e-3);
    double sum = 0, last = 0, steps = 20000;
    for (int i = 1; i <= steps; ++i) {
      const double x = 1.05 * law.x_cap * (i / steps) * (i / steps), middle = (x + last) / 2;
      Loading<double> here;
      law.force(middle, here);
      sum += here.F * (x - last);
      last = x;
      if (i % 997 == 0) { EXPECT_NEAR(law.work_bar(x), sum, 2e-6 * sum) << x << ' ' << int(loading); }
    }
  }
}

TEST(Shahin, SmallOverlapWithoutHardeningIsCloseToSimilarity) {
  // D1 = 1.7527 against sqrt(2 c^2) = 1.6911, H_max = 3.101 against 3: within 12 % as x -> 0
  const auto law = prepare(material(0, LoadingCase::simple), 1e-3);
  const auto similarity = prepare(SimilarityMaterial{200e9, 0.3, 100e6, 0}, 1e-3);
  const double ratio = law.loading(1e-9).F / similarity.loading(1e-9).F;
  EXPECT_NEAR(ratio, std::pow(1.7527 / 1.6911, 2) * 3.101 / 3, 1e-3);
}

TEST(Shahin, PlaneIsTheMirrorOfTwoEqualSpheres) {
  for (LoadingCase loading : all_cases) {
    const auto two = prepare(material(0.4, loading), 1e-3),
               wall = prepare_on_rigid_plane(material(0.4, loading), 1e-3);
    State s2, s1;
    for (double delta : {1e-7, 2e-5, 1.7e-4, 1.6999e-4, 1.8e-4}) {
      const Response t = evaluate(two, s2, 2 * delta), w = evaluate(wall, s1, delta);
      EXPECT_NEAR(t.force, w.force, 1e-10 * t.force);
      EXPECT_NEAR(t.contact_radius, w.contact_radius, 1e-10 * t.contact_radius);
      s2 = t.state, s1 = w.state;
    }
  }
}

TEST(Shahin, RandomPathsCreateNothing) {
  for_random_cases(paths_per_law / 100, [] {
    const auto loading = static_cast<LoadingCase>(*rc::gen::resize(100, rc::gen::inRange(0, 3)));
    const auto variant = static_cast<ShahinVariant>(*rc::gen::resize(100, rc::gen::inRange(0, 2)));
    const double inverse_m = unit();
    ShahinCoefficients<double> coefficients; // 0: as published, or as if fitted
    if (unit() < 0.5) {
      coefficients = ShahinCoefficients<double>::published(loading, inverse_m, variant);
      for (const auto& c : shahin_coefficients) coefficients.*c.member *= between(0.97, 1.03);
      coefficients.x_min = smaller(1.0, coefficients.x_min);
    }
    const auto draw = [&] {
      const double kappa = log_between(1e6, 1e9);
      ShahinMaterial m{kappa * log_between(10, 1e5), between(0, 0.49), kappa, inverse_m, loading, variant};
      m.coefficients = coefficients;
      return m;
    };
    const ShahinMaterial m1 = draw(), m2 = unit() < 0.5 ? m1 : draw();
    const double R1 = log_between(1e-6, 1e-1), R2 = unit() < 0.3   ? R1
                                                    : unit() < 0.3 ? infinity
                                                                   : R1 * log_between(0.05, 20);
    const auto law = prepare(m1, R1, m2, R2), swapped = prepare(m2, R2, m1, R1);
    for (int i = 0; i < 100; ++i)
      holds_on_path(law, swapped, random_path(1.1 * law.x_cap / law.pair.x_per_gamma));
  });
}

TEST(Shahin, AnyFiniteOverlapHasAnAnswer) {
  for (LoadingCase loading : all_cases) {
    const Shahin law = prepare(material(0.3, loading), 1e-3);
    double last = 0;
    for (double gamma :
         {-1e300, -1.0, 0.0, 1e-300, 1e-30, 1e-9, 1e-5, 1e-4, 3e-4, 3.9e-4, 1e-3, 2e-3, 1.0, 1e300}) {
      const Response r = evaluate(law, State{}, gamma);
      EXPECT_TRUE(std::isfinite(r.force) && std::isfinite(r.dissipated_work) &&
                  std::isfinite(r.mean_pressure));
      EXPECT_GE(r.force, last) << gamma;
      last = r.force;
    }
    EXPECT_FALSE(evaluate(law, State{}, 1.9e-3).in_range);
  }
}

} // namespace
