#include "platen/law/agarwal.hpp"

#include "random_paths.hpp"

#include <random>

namespace {

using namespace platen::law;
using namespace platen::law::testing;

using Curve = AgarwalCurve<double>;
constexpr auto all_cases = {LoadingCase::simple, LoadingCase::die, LoadingCase::hydrostatic};
constexpr auto both_variants = {AgarwalVariant::published, AgarwalVariant::hertz_radius};

AgarwalMaterial soft_metal(LoadingCase loading, AgarwalVariant variant = AgarwalVariant::hertz_radius) {
  return {100e6, 0.3, 1e6, loading, variant}; // E/sigma_y = 100, as the independent finite elements
}

/// Materials inside the calibrated range (Table 2.1): lambda 117..5933.
std::vector<Curve> thousand_random_curves(LoadingCase loading, AgarwalVariant variant) {
  std::mt19937_64 random(20261122);
  std::uniform_real_distribution<double> u(0, 1);
  std::vector<Curve> curves;
  for (int i = 0; i < 1000; ++i) {
    const double lambda = 117 * std::pow(5933.0 / 117, u(random)), nu = 0.2 + 0.28 * u(random);
    curves.push_back(Curve::make(loading, variant, lambda, lambda * (1 - nu * nu) / (3 * (1 - 2 * nu))));
  }
  return curves;
}

TEST(Agarwal, QuinticsOfAppendixCHaveTheirRootAtTheLeastPressure) { // (C.2), (C.4) with R = 1, gamma = 2x
  const double pi2 = std::numbers::pi * std::numbers::pi, Gamma = 0.0593;
  for (double lambda : {117.0, 1000.0, 5933.0}) {
    const auto dc = Curve::make(LoadingCase::die, AgarwalVariant::published, lambda, lambda);
    const auto hc = Curve::make(LoadingCase::hydrostatic, AgarwalVariant::published, lambda, lambda);
    const auto quintic = [&](const RadiusPolynomial<double>& D, double g, bool die) {
      const double c5 = pi2 * D.D5 * D.D5 / 32, c4 = -pi2 * D.D3 * D.D5 / 8,
                   c3 = pi2 * D.D3 * D.D3 / 8 + pi2 * D.D1 * D.D5 / 4, c2 = -pi2 * D.D1 * D.D3 / 2,
                   c1 = pi2 * D.D1 * D.D1 / 2;
      const double left = ((((c5 * g + c4) * g + c3) * g + c2) * g + c1) * g;
      return die ? left + 72 * Gamma * g - 144 * Gamma
                 : left + Gamma * g * ((((4.5 * g - 45) * g + 180) * g - 360) * g + 360) - 144 * Gamma;
    };
    EXPECT_NEAR(quintic(dc.radius, 2 * dc.x_min, true), 0, 1e-11);
    EXPECT_NEAR(quintic(hc.radius, 2 * hc.x_min, false), 0, 1e-11);
  }
}

TEST(Agarwal, RegimesJoinWithoutStepOrKink) {
  for (LoadingCase loading : all_cases)
    for (const Curve& c : thousand_random_curves(loading, AgarwalVariant::published)) {
      double H1, H2, s1, s2;
      const auto joined = [&](const char* which, double slope_scale) {
        EXPECT_NEAR(H1, H2, 1e-12 * H1) << which << " lambda " << c.lambda;
        EXPECT_NEAR(s1, s2, 1e-9 * slope_scale) << which << " lambda " << c.lambda;
      };
      c.elastic(c.x_y, H1, s1), c.elastic_plastic(c.x_y, H2, s2);
      joined("yield", s1);
      c.elastic_plastic(c.x_h, H1, s1), c.plastic(c.x_h, H2, s2);
      joined("H_max", H1);
      if (loading == LoadingCase::simple) continue;
      c.plastic(c.x_min, H1, s1), c.low_compressibility(c.x_min, H2, s2);
      joined("H_min", H1);
      c.low_compressibility(c.x_zp, H1, s1), c.elastic_volumetric(c.x_zp, H2, s2);
      joined("filled", s1);
      if (::testing::Test::HasFailure()) return;
    }
}

TEST(Agarwal, HertzRadiusJoinsWithoutStepOrKink) {
  for (LoadingCase loading : all_cases)
    for (const Curve& c : thousand_random_curves(loading, AgarwalVariant::hertz_radius))
      for (double joint : {c.x_y, c.x_joined}) {
        double a1, a2, s1, s2;
        c.contact_radius(joint * (1 - 1e-14), a1, s1), c.contact_radius(joint * (1 + 1e-14), a2, s2);
        EXPECT_NEAR(a1, a2, 1e-12 * a1);
        EXPECT_NEAR(s1, s2, 1e-11);
      }
}

TEST(Agarwal, StiffnessIsTheDerivativeOfTheForce) {
  for (auto variant : both_variants)
    for (LoadingCase loading : all_cases)
      for (const Curve& c : thousand_random_curves(loading, variant)) {
        const double joints[] = {c.x_y, c.x_h, c.x_min, c.x_zp, c.x_joined};
        for (double f = 0.03; f < 1; f += 0.094) {
          const double x = c.x_y * std::pow(0.55 / c.x_y, f * 1.1 - 0.05), h = 1e-4 * x;
          bool near =
              false; // a five-point stencil must not straddle a joint or the steep end of the closing cell
          for (double joint : joints) near = near || std::abs(x - joint) < 0.01 * joint;
          if (near) continue;
          const double d =
              (8 * (c.F_bar(x + h) - c.F_bar(x - h)) - (c.F_bar(x + 2 * h) - c.F_bar(x - 2 * h))) / (12 * h);
          EXPECT_NEAR(d, c.at(x).slope, 1e-6 * std::abs(c.at(x).slope))
              << c.lambda << ' ' << x << ' ' << int(loading);
        }
        if (::testing::Test::HasFailure()) return;
      }
}

TEST(Agarwal, TablesFollowTheFormulasToOneInTenThousand) {
  double worst = 0;
  std::mt19937_64 random(7);
  for (auto variant : both_variants)
    for (LoadingCase loading : all_cases)
      for (int i = 0; i < 60; ++i) {
        AgarwalMaterial m = soft_metal(loading, variant);
        m.E = m.sigma_y * 107 * std::pow(50.0, std::uniform_real_distribution<double>(0, 1)(random));
        const Agarwal law = prepare(m, 1e-3);
        for (double x = law.curve.x_y * 0.5; x < law.x_cap; x *= 1.002) {
          Loading<double> here;
          law.force(x, here);
          worst = std::max(worst, std::abs(here.F / law.curve.F_bar(x) - 1));
        }
      }
  RecordProperty("worst", std::to_string(worst));
  EXPECT_LE(worst, 1e-4);
}

TEST(Agarwal, TabledRadiusFollowsTheFormula) {
  for (auto variant : both_variants)
    for (LoadingCase loading : all_cases) {
      const Agarwal law = prepare(soft_metal(loading, variant), 1e-3);
      for (double x = law.curve.x_y * 0.5; x < law.x_cap; x *= 1.003)
        ASSERT_NEAR(law.loading(x / law.pair.x_per_gamma).a / (law.pair.R_e * law.curve.at(x).a), 1, 2e-5)
            << x;
    }
}

TEST(Agarwal, TabledCurveIsContinuousAtItsOwnJoints) {
  for (LoadingCase loading : all_cases) {
    const Agarwal law = prepare(soft_metal(loading), 1e-3);
    for (double joint : {law.curve.x_y, law.plastic.x_high(), law.closure.x_high, law.x_cap}) {
      if (joint <= 0 || joint > law.x_cap) continue;
      Loading<double> one, two;
      law.force(joint * (1 - 1e-15), one), law.force(joint * (1 + 1e-15), two);
      const double F1 = one.F, s1 = one.slope, F2 = two.F, s2 = two.slope;
      EXPECT_NEAR(F1, F2, 1e-12 * F1 + 4e-15 * joint * s1)
          << joint; // the second term: x itself moves by 2e-15
      EXPECT_NEAR(s1, s2, 1e-9 * s1) << joint;
    }
  }
}

TEST(Agarwal, WorkIsTheIntegralOfTheForce) {
  for (auto variant : both_variants)
    for (LoadingCase loading : all_cases) {
      const Agarwal law = prepare(soft_metal(loading, variant), 1e-3);
      double sum = 0, last = 0, steps = 20000;
      for (int i = 1; i <= steps; ++i) { // midpoint rule on a grid that grows like x^2
        const double x = 1.05 * law.x_cap * (i / steps) * (i / steps), middle = (x + last) / 2;
        Loading<double> here;
        law.force(middle, here);
        sum += here.F * (x - last);
        last = x;
        if (i % 997 == 0) { EXPECT_NEAR(law.work_bar(x), sum, 2e-6 * sum) << x << ' ' << int(loading); }
      }
    }
}

TEST(Agarwal, ElasticLimitIsHertz) {
  const AgarwalMaterial m = soft_metal(LoadingCase::simple);
  const double R1 = 1e-3, R2 = 4e-3;
  AgarwalMaterial other = m;
  other.E = 3 * m.E, other.nu = 0.2;
  const Agarwal law = prepare(m, R1, other, R2);
  const double gamma = 0.9 * law.gamma_elastic;
  const double E_star = 1 / ((1 - 0.09) / m.E + (1 - 0.04) / other.E), R_star = 1 / (1 / R1 + 1 / R2);
  const double F = 4.0 / 3 * E_star * std::sqrt(R_star) * std::pow(gamma, 1.5);
  EXPECT_NEAR(law.loading(gamma).F, F, 1e-12 * F);
  // and unloading from there is lossless
  const State top = evaluate(law, State{}, gamma).state;
  EXPECT_EQ(evaluate(law, top, gamma / 2).force, law.loading(gamma / 2).F);
  EXPECT_EQ(evaluate(law, top, gamma / 2).dissipated_work, 0);
  // the published radius gives 2.2 to 3.1 times that over the calibrated range
  for (double lambda : {117.0, 5933.0}) {
    const double ratio = std::pow(agarwal_radius(LoadingCase::simple, lambda).D1, 2);
    EXPECT_GE(ratio, 2.15);
    EXPECT_LE(ratio, 3.1);
  }
}

TEST(Agarwal, PlaneIsTheMirrorOfTwoEqualSpheres) {
  for (LoadingCase loading : all_cases) {
    const auto two = prepare(soft_metal(loading), 1e-3),
               wall = prepare_on_rigid_plane(soft_metal(loading), 1e-3);
    State s2, s1;
    for (double delta : {1e-7, 2e-5, 1.7e-4, 1.6e-4, 1.8e-4}) {
      const Response t = evaluate(two, s2, 2 * delta), w = evaluate(wall, s1, delta);
      EXPECT_NEAR(t.force, w.force, 1e-10 * t.force);
      EXPECT_NEAR(t.contact_radius, w.contact_radius, 1e-10 * t.contact_radius);
      EXPECT_NEAR(2 * t.stiffness, w.stiffness, 1e-9 * w.stiffness);
      s2 = t.state, s1 = w.state;
    }
  }
}

TEST(Agarwal, RefusesTooSoftAMaterial) {
  AgarwalMaterial m = soft_metal(LoadingCase::simple);
  m.E = 15e6;
  try {
    (void)prepare(m, 1e-3);
    FAIL();
  } catch (const BadParameter& e) {
    EXPECT_STREQ(e.what(), "agarwal: lambda = E/((1 - nu^2) sigma_y) = 16.4835 is not in [22.1, inf)");
  }
}

TEST(Agarwal, CoefficientsOfAFitReplaceThePublishedOnes) {
  const double lambda = 100 / 0.91, zeta = 100 / 1.2;
  for (LoadingCase loading : all_cases) {
    AgarwalMaterial m = soft_metal(loading, AgarwalVariant::published);
    auto fitted = AgarwalCoefficients<double>::published(loading, lambda, zeta);
    fitted.D1 *= 1.02, fitted.H_max *= 0.96;
    m.coefficients.D1 = fitted.D1, m.coefficients.H_max = fitted.H_max; // the others stay 0: as published
    const auto expected = Curve::make(loading, AgarwalVariant::published, lambda, zeta, fitted);
    const Agarwal law = prepare(m, 1e-3);
    for (double x : {0.01, 0.05, 0.15, 0.18})
      EXPECT_NEAR(law.loading(x / law.pair.x_per_gamma).F / law.force_scale, expected.F_bar(x),
                  1e-4 * expected.F_bar(x));
    EXPECT_NE(expected.F_bar(0.1), Curve::make(loading, AgarwalVariant::published, lambda, zeta).F_bar(0.1));
  }
}

TEST(Agarwal, RefusesCoefficientsThatMakeNoLaw) {
  const auto refused = [](double AgarwalCoefficients<double>::*member, double value) {
    AgarwalMaterial m = soft_metal(LoadingCase::die);
    m.coefficients.*member = value;
    EXPECT_THROW(prepare(m, 1e-3), BadParameter) << value;
  };
  using C = AgarwalCoefficients<double>;
  for (const double D1 : {-1.0, std::nan(""), infinity}) refused(&C::D1, D1);
  refused(&C::D3, 5);      // the radius falls
  refused(&C::H_max, 1);   // first yield is at 1.1
  refused(&C::H_max, 1.3); // below H_min
  refused(&C::x_h, 0.5);   // beyond x_min
  refused(&C::x_h, 1e-6);  // before first yield
  refused(&C::r, 0.9);
  refused(&C::H_min, 3);
  refused(&C::l, 1);
}

TEST(Agarwal, RandomPathsCreateNothing) {
  // Preparing a table takes far longer than a path: a thousand random laws, a hundred paths each.
  for_random_cases(paths_per_law / 100, [] {
    const auto loading = static_cast<LoadingCase>(*rc::gen::resize(100, rc::gen::inRange(0, 3)));
    const auto variant = static_cast<AgarwalVariant>(*rc::gen::resize(100, rc::gen::inRange(0, 2)));
    const auto draw = [&] {
      const double sigma_y = log_between(1e6, 5e8), nu = between(0, 0.49);
      AgarwalMaterial m{sigma_y * (1 - nu * nu) * log_between(60, 6000), nu, sigma_y, loading, variant};
      if (unit() < 0.5) return m;
      const double lambda = m.E / ((1 - nu * nu) * sigma_y), zeta = m.E / (3 * (1 - 2 * nu)) / sigma_y;
      m.coefficients = AgarwalCoefficients<double>::published(loading, lambda, zeta); // as if fitted
      for (const auto& c : agarwal_coefficients) m.coefficients.*c.member *= between(0.97, 1.03);
      m.coefficients.r = larger(1.0, m.coefficients.r);
      m.coefficients.x_min = smaller(1.0, m.coefficients.x_min);
      m.coefficients.l = smaller(0.9999, m.coefficients.l);
      return m;
    };
    const AgarwalMaterial m1 = draw(), m2 = unit() < 0.5 ? m1 : draw();
    const double R1 = log_between(1e-6, 1e-1), R2 = unit() < 0.3   ? R1
                                                    : unit() < 0.3 ? infinity
                                                                   : R1 * log_between(0.05, 20);
    const double E_star = 1 / ((1 - m1.nu * m1.nu) / m1.E + (1 - m2.nu * m2.nu) / m2.E);
    RC_PRE(E_star / std::min(m1.sigma_y, m2.sigma_y) > 22.2);
    const auto law = prepare(m1, R1, m2, R2), swapped = prepare(m2, R2, m1, R1);
    for (int i = 0; i < 100; ++i)
      holds_on_path(law, swapped, random_path(1.1 * law.x_cap / law.pair.x_per_gamma));
  });
}

TEST(Agarwal, AnyFiniteOverlapHasAnAnswer) {
  for (LoadingCase loading : all_cases) {
    const Agarwal law = prepare(soft_metal(loading), 1e-3);
    double last = 0;
    for (double gamma :
         {-1e300, -1.0, 0.0, 1e-300, 1e-30, 1e-9, 1e-5, 1e-4, 3e-4, 4e-4, 1e-3, 2e-3, 1.0, 1e300}) {
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
