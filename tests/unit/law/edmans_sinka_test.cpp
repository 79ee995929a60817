#include "platen/law/catalogue.hpp"
#include "platen/law/edmans_sinka.hpp"
#include "platen/law/edmans_sinka_appendix.hpp"
#include "platen/law/tabulate.hpp"

#include "random_paths.hpp"

namespace {

using namespace platen::law;
using namespace platen::law::testing;

EdmansSinkaMaterial some_material() { // the example of the law card in the project's schema
  EdmansSinkaMaterial m;
  m.sigma_ref = 8.61e6;
  m.E = 4.417e8;
  m.nu = 0.1472;
  m.k = 4.2;
  m.delta_t = 0.09;
  m.a = 3.5;
  return m;
}

EdmansSinkaMaterial random_material() {
  EdmansSinkaMaterial m;
  m.sigma_ref = log_between(1e5, 1e9);
  m.E = m.sigma_ref * log_between(3, 500); // E_bar of the paper's study (6.2)
  m.nu = between(0, 0.49);
  m.k = log_between(0.3, 10);
  m.delta_t = between(0.01, 0.6);
  m.a = log_between(0.1, 12);
  m.corner = smaller(0.95, 0.849 / (m.a * m.delta_t)) * between(0.01, 1);
  m.variant = static_cast<EdmansSinkaVariant>(*rc::gen::inRange(0, 4));
  if (unit() < 0.5) { // radii of a press; d ln a / d ln x is 0.29 to 0.72 in the pools of the catalogue
    m.radii = *rc::gen::inRange(1, 9);
    for (int i = 0; i < m.radii; ++i) {
      m.radius_delta_bar[i] = i ? m.radius_delta_bar[i - 1] * between(1.05, 4) : 0.005;
      m.a_bar[i] =
          i ? m.a_bar[i - 1] * std::pow(m.radius_delta_bar[i] / m.radius_delta_bar[i - 1], between(0, 0.9))
            : between(0.07, 0.11);
    }
  }
  if (unit() < 0.5) { // measured unloading curves; the paper's Fig. 15 shows alpha 1..2, beta 1..4
    m.unloadings = *rc::gen::inRange(1, 5);
    for (int i = 0; i < m.unloadings; ++i) {
      m.unload_delta_bar[i] = 0.1 + 0.1 * i;
      m.alpha[i] = 1.5;
      m.beta[i] = 1 + 0.2 * i;
    }
  }
  return m;
}

TEST(EdmansSinka, LoadingIsEquationSix) {
  const EdmansSinkaMaterial m = some_material();
  const double R = 1e-3;
  auto law = prepare(m, R);
  const double scale = std::numbers::pi * R * R * m.sigma_ref;
  for (double delta_bar : {0.01, 0.05, 0.09, 0.2, 0.5}) {
    const double F_bar =
        delta_bar <= 0.09 ? 4.2 * delta_bar : 4.2 * 0.09 * std::exp(3.5 * (delta_bar - 0.09));
    const Response r = evaluate(law, State{}, 2 * R * delta_bar);
    EXPECT_NEAR(r.force / scale, F_bar, 1e-13);
    EXPECT_EQ(r.branch, Branch::loading);
    EXPECT_TRUE(r.in_range);
  }
  EXPECT_FALSE(evaluate(law, State{}, 2 * R * 0.51).in_range); // delta_bar_max = 0.5, text after (6)
}

TEST(EdmansSinka, RoundedVariantHasNoKinkAndLeavesTheRestAlone) {
  for (double a : {0.5, 3.5, 12.0}) {
    const EdmansSinkaCurve<double> sharp{4.2, 0.09, a, 0.5, EdmansSinkaVariant::published};
    const EdmansSinkaCurve<double> round{4.2, 0.09, a, 0.5, EdmansSinkaVariant::c1};
    for (double x : {0.02, 0.045, 0.135, 0.3}) EXPECT_NEAR(round.F_bar(x), sharp.F_bar(x), 1e-14);
    for (double joint : {0.045, 0.135}) {
      EXPECT_NEAR(round.slope(joint * (1 - 1e-13)), round.slope(joint * (1 + 1e-13)), 1e-9);
      EXPECT_NEAR(round.F_bar(joint * (1 - 1e-15)), round.F_bar(joint * (1 + 1e-15)), 1e-12);
    }
  }
}

TEST(EdmansSinka, HertzLikeVariantStartsWithThreeHalves) {
  const EdmansSinkaCurve<double> curve{4.2, 0.09, 3.5, 0.5, EdmansSinkaVariant::hertz_like};
  EXPECT_NEAR(curve.F_bar(0.04) / curve.F_bar(0.01), 8.0, 1e-12); // 4^(3/2)
  EXPECT_NEAR(curve.F_bar(0.09), 4.2 * 0.09, 1e-15);
}

TEST(EdmansSinka, SlopeAndWorkAreDerivativeAndIntegralOfTheForce) {
  for (int v = 0; v < 4; ++v) {
    const EdmansSinkaCurve<double> c{4.2, 0.09, 3.5, 0.4, static_cast<EdmansSinkaVariant>(v)};
    for (double x : {0.01, 0.06, 0.11, 0.2, 0.45, 0.99, 1.3}) {
      const double h = 1e-5 * x;
      EXPECT_NEAR((c.F_bar(x + h) - c.F_bar(x - h)) / (2 * h), c.slope(x), 1e-6 * c.slope(x))
          << v << ' ' << x;
      EXPECT_NEAR((c.work(x + h) - c.work(x - h)) / (2 * h), c.F_bar(x), 1e-6 * c.F_bar(x)) << v << ' ' << x;
    }
  }
}

/// Value and derivative with respect to one parameter: what a fit feeds through the curve.
struct Dual {
  double v = 0, d = 0;
  Dual() = default;
  explicit Dual(double value, double derivative = 0) : v(value), d(derivative) {}
  friend Dual operator+(Dual a, Dual b) { return Dual(a.v + b.v, a.d + b.d); }
  friend Dual operator-(Dual a, Dual b) { return Dual(a.v - b.v, a.d - b.d); }
  friend Dual operator*(Dual a, Dual b) { return Dual(a.v * b.v, a.d * b.v + a.v * b.d); }
  friend Dual operator/(Dual a, Dual b) { return Dual(a.v / b.v, (a.d * b.v - a.v * b.d) / (b.v * b.v)); }
  friend bool operator<(Dual a, Dual b) { return a.v < b.v; }
  friend bool operator<=(Dual a, Dual b) { return a.v <= b.v; }
  friend bool operator>(Dual a, Dual b) { return a.v > b.v; }
  friend bool operator==(Dual a, Dual b) { return a.v == b.v; }
  friend Dual exp(Dual a) { return Dual(std::exp(a.v), std::exp(a.v) * a.d); }
  friend Dual sqrt(Dual a) { return Dual(std::sqrt(a.v), a.d / (2 * std::sqrt(a.v))); }
  friend Dual cbrt(Dual a) { return Dual(std::cbrt(a.v), a.d * std::cbrt(a.v) / (3 * a.v)); }
  friend Dual pow(Dual a, Dual b) {
    const double p = std::pow(a.v, b.v);
    return Dual(p, p * (b.d * std::log(a.v) + b.v * a.d / a.v));
  }
};

TEST(EdmansSinka, FitsCanDifferentiateTheCurveByItsParameters) {
  for (int v = 0; v < 4; ++v)
    for (double x : {0.03, 0.1, 0.3}) {
      const auto variant = static_cast<EdmansSinkaVariant>(v);
      const double h = 1e-6;
      const auto F = [&](double k, double t, double a) {
        return EdmansSinkaCurve<double>{k, t, a, 0.5, variant}.F_bar(x);
      };
      const auto d = [&](int which) {
        EdmansSinkaCurve<Dual> c{Dual(4.2, which == 0), Dual(0.09, which == 1), Dual(3.5, which == 2),
                                 Dual(0.5), variant};
        return c.F_bar(Dual(x)).d;
      };
      EXPECT_NEAR(d(0), (F(4.2 + h, 0.09, 3.5) - F(4.2 - h, 0.09, 3.5)) / (2 * h), 1e-7);
      EXPECT_NEAR(d(1), (F(4.2, 0.09 + h, 3.5) - F(4.2, 0.09 - h, 3.5)) / (2 * h), 1e-6);
      EXPECT_NEAR(d(2), (F(4.2, 0.09, 3.5 + h) - F(4.2, 0.09, 3.5 - h)) / (2 * h), 1e-7);
    }
}

TEST(EdmansSinka, TheWholeLawRunsOnAnotherScalar) {
  EdmansSinka<Dual> law;
  const auto base = prepare(some_material(), 1e-3);
  law.curve = {Dual(4.2, 1), Dual(0.09), Dual(3.5), Dual(0.5), EdmansSinkaVariant::published};
  law.radius_log_slope = Dual(base.radius_log_slope);
  law.pair = {
      {{Dual(base.pair.body[0].curvature), Dual(base.pair.body[0].compliance), Dual(base.pair.body[0].nu)},
       {Dual(base.pair.body[1].curvature), Dual(base.pair.body[1].compliance), Dual(base.pair.body[1].nu)}},
      Dual(base.pair.A),
      Dual(base.pair.B),
      Dual(base.pair.E_star),
      Dual(base.pair.R_e),
      Dual(base.pair.x_per_gamma)};
  law.force_scale = Dual(base.force_scale);
  law.gamma_limit = Dual(base.gamma_limit);
  const auto up = evaluate(law, BasicState<Dual>{}, Dual(2e-4));
  const auto down = evaluate(law, up.state, Dual(1.9e-4));
  EXPECT_NEAR(up.force.v, base.loading(2e-4).F, 1e-12);
  EXPECT_NEAR(up.force.d, up.force.v / 4.2, 1e-10); // F is proportional to k
  EXPECT_EQ(down.branch, Branch::unloading);
  EXPECT_GT(down.force.d, 0);
}

TEST(EdmansSinka, ContactRadiusIsAPowerBetweenTheGivenOnes) {
  EdmansSinkaMaterial m = some_material();
  const double at[] = {0.02, 0.1, 0.3, 0.5}, a[] = {0.19, 0.46, 0.69, 0.93};
  m.radii = 4;
  std::copy(at, at + 4, m.radius_delta_bar);
  std::copy(a, a + 4, m.a_bar);
  const double R = 2e-3;
  const auto law = prepare(m, R);
  const auto a_bar = [&](double x) { return law.loading(2 * R * x).a / R; };
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(a_bar(at[i]), a[i], 1e-14);
  EXPECT_NEAR(a_bar(0.005), 0.19 / 2, 1e-14);                               // sqrt(x)
  EXPECT_NEAR(a_bar(std::sqrt(0.02 * 0.1)), std::sqrt(0.19 * 0.46), 1e-14); // in the middle of a power
  EXPECT_NEAR(a_bar(0.5 * 0.5 / 0.3), 0.93 * 0.93 / 0.69, 1e-14);           // the last power goes on
  EXPECT_EQ(a_bar(1), a_bar(1.5));                                          // to where the curve ends
  EXPECT_NEAR(evaluate(tabulate(law), State{}, 2 * R * 0.2).contact_radius, R * a_bar(0.2), 5e-5 * R);

  m.a_bar[2] = 0.45;
  EXPECT_THROW(prepare(m, R), BadParameter); // it may not fall
  m.radii = 1;
  EXPECT_NEAR(prepare(m, R).loading(2 * R * 0.08).a / R, 2 * 0.19, 1e-14); // one alone: sqrt(x)
}

TEST(EdmansSinka, UnloadingFollowsEquationsNineToFourteen) {
  EdmansSinkaMaterial m = some_material();
  m.unloadings = 2;
  m.unload_delta_bar[0] = 0.1, m.unload_delta_bar[1] = 0.5;
  m.alpha[0] = 1.4, m.alpha[1] = 1.2;
  m.beta[0] = 1.3, m.beta[1] = 1.6;
  const double R = 2e-3, x_max = 0.3;
  auto law = prepare(m, R);
  const State state = evaluate(law, State{}, 2 * R * x_max).state;
  const double alpha = 1.3, beta = 1.45; // linear between
  const double F_bar_max = 4.2 * 0.09 * std::exp(3.5 * (x_max - 0.09));
  const double k_H = 4 / (3 * std::numbers::pi) * (m.E / m.sigma_ref) / (1 - m.nu * m.nu); // (10)
  const double delta_H0 = x_max - std::pow(F_bar_max / k_H, 2.0 / 3);                      // (12)
  const double delta_0 = x_max - (x_max - delta_H0) / beta;                                // (11)
  for (double x : {0.29, 0.28, 0.275}) {
    const double F_bar = F_bar_max * std::pow((x - delta_0) / (x_max - delta_0), alpha); // (13)
    const double F = evaluate(law, state, 2 * R * x).force;
    EXPECT_NEAR(F / (std::numbers::pi * R * R * m.sigma_ref), F_bar, 1e-12) << x;
  }
  const Response apart = evaluate(law, state, 2 * R * delta_0 * 0.999);
  EXPECT_EQ(apart.branch, Branch::separated);
  EXPECT_EQ(apart.force, 0);
}

TEST(EdmansSinka, GenericUnloadingHasTheSlopeOfAFiniteSphere) {
  const EdmansSinkaMaterial m = some_material();
  const double R = 1e-3;
  const auto law = prepare(m, R);
  const double gamma = 2 * R * 0.1;
  const Response top = evaluate(law, State{}, gamma);
  const Response down = evaluate(law, top.state, gamma * (1 - 1e-9));
  // the rule of the project's schema, written out for one side in delta = gamma/2
  const double a = top.contact_radius, nu = m.nu, E_star = m.E / (1 - nu * nu), s = a * a + 4 * R * R;
  const double f = 2 * (1 + nu) * R * R / std::pow(s, 1.5) + (1 - nu * nu) / std::sqrt(s);
  const double S = 1 / (1 / (2 * E_star * a) - f / (std::numbers::pi * m.E));
  EXPECT_GT(S, 2 * top.stiffness); // else this test would see the loading slope
  EXPECT_NEAR(down.stiffness, S / 2, 1e-6 * S);
}

TEST(EdmansSinka, PlaneIsTheMirrorOfTwoEqualSpheres) {
  const EdmansSinkaMaterial m = some_material();
  const auto two = prepare(m, 1e-3);
  const auto wall = prepare_on_rigid_plane(m, 1e-3);
  State s_two, s_wall;
  for (double delta : {1e-5, 8e-5, 3e-4, 2.9e-4, 2.7e-4, 3.2e-4}) {
    const Response t = evaluate(two, s_two, 2 * delta), w = evaluate(wall, s_wall, delta);
    EXPECT_NEAR(t.force, w.force, 1e-12 * t.force);
    EXPECT_NEAR(t.contact_radius, w.contact_radius, 1e-12 * t.contact_radius);
    EXPECT_NEAR(2 * t.stiffness, w.stiffness, 1e-12 * w.stiffness);
    EXPECT_NEAR(t.dissipated_work, 2 * w.dissipated_work, 1e-11 * t.dissipated_work);
    s_two = t.state, s_wall = w.state;
  }
}

TEST(EdmansSinka, AppendixAStandsForTheThreeParameters) {
  const auto law = [](const std::string& more) {
    return make_law("edmans-sinka", "",
                    parameter_texts("radius_m=1e-3 E_Pa=1e9 nu=0.2 sigma_ref_Pa=1e7 " + more));
  };
  // (A.1): k = 3.90 at Gamma_bar 1, E_bar 100 (tests/verification/law/edmans_sinka_test.cpp)
  EXPECT_NEAR(evaluate(law("Gamma_bar=1"), State{}, 2e-3 * 0.05).force / (std::numbers::pi * 1e-6 * 1e7),
              3.90 * 0.05, 3e-4);
  EXPECT_THROW((void)law("Gamma_bar=1 k=4"), BadParameter);
  EXPECT_THROW((void)law("Gamma_bar=0.1"), BadParameter);
  EXPECT_THROW((void)law("k=4"), BadParameter);
  EXPECT_THROW((void)make_law("edmans-sinka", "",
                              parameter_texts("radius_m=1e-3 E_Pa=1e9 nu=0.2 sigma_ref_Pa=1e6 Gamma_bar=1")),
               BadParameter);
}

TEST(EdmansSinka, RefusesWhatIsNoMaterial) {
  EdmansSinkaMaterial m = some_material();
  m.nu = 0.5;
  try {
    (void)prepare(m, 1e-3);
    FAIL();
  } catch (const BadParameter& e) { EXPECT_STREQ(e.what(), "edmans-sinka: nu = 0.5 is not in [0, 0.5)"); }
  m = some_material();
  m.k = std::nan("");
  EXPECT_THROW((void)prepare(m, 1e-3), BadParameter);
  EXPECT_THROW((void)prepare(some_material(), 0), BadParameter);
}

TEST(EdmansSinka, OfUnlikeStrengthIsInRangeWhileTheHarderOneSinksInALittle) { // pair.hpp
  EdmansSinkaMaterial soft = some_material(), hard = soft;
  hard.sigma_ref *= 100;
  const auto in_range = [](const auto& law, double x) { return law.in_range(x / law.pair.x_per_gamma); };
  for (const double R : {infinity, 2.0}) {
    EXPECT_TRUE(in_range(prepare(hard, 0.5, soft, R), 0.02));
    EXPECT_FALSE(in_range(prepare(hard, 0.5, soft, R), 0.021));
    EXPECT_FALSE(in_range(prepare(soft, R, hard, 0.5), 0.021));
    EXPECT_TRUE(in_range(prepare(hard, R, soft, 0.5), 0.49));
    EXPECT_TRUE(in_range(prepare(soft, 0.5, soft, R), 0.49));
  }
  EXPECT_TRUE(in_range(prepare(hard, 0.5, soft, 0.5), 0.199)); // 0.4 of its radius
  EXPECT_FALSE(in_range(prepare(hard, 0.5, soft, 0.5), 0.201));
}

TEST(EdmansSinka, AnyFiniteOverlapHasAnAnswer) {
  const auto law = prepare(some_material(), 1e-3);
  double last = 0;
  for (double gamma : {-1e300, -1.0, 0.0, 1e-300, 1e-9, 1e-3, 2e-3, 1.0, 1e10, 1e300}) {
    const Response r = evaluate(law, State{}, gamma);
    EXPECT_TRUE(std::isfinite(r.force) && std::isfinite(r.dissipated_work) && std::isfinite(r.mean_pressure));
    EXPECT_GE(r.force, last);
    last = r.force;
    const Response back = evaluate(law, r.state, 0.0);
    EXPECT_EQ(back.force, 0);
  }
}

TEST(EdmansSinka, RandomPathsCreateNothing) {
  for_random_cases(paths_per_law, [] {
    const EdmansSinkaMaterial m1 = random_material();
    const EdmansSinkaMaterial m2 = unit() < 0.5 ? m1 : random_material();
    const double R1 = log_between(1e-6, 1e-1);
    const double R2 = unit() < 0.3 ? R1 : unit() < 0.3 ? infinity : R1 * log_between(0.05, 20);
    const auto law = prepare(m1, R1, m2, R2);
    holds_on_path(law, prepare(m2, R2, m1, R1), random_path(1.5 / law.pair.x_per_gamma));
  });
}

} // namespace
