// Two bodies joined from what each does against its like (joined.hpp): where that is exact, and that it is
// sound.

#include "platen/law/catalogue.hpp"
#include "platen/law/joined.hpp"
#include "random_material.hpp"

#include <gtest/gtest.h>

namespace {

using namespace platen::law;
using namespace platen::law::testing;

Law like(const LawChoice& one) { return make_law(one, 1, one, 1); }

/// The same pair from its own formulas, and joined.
void expect_same(const LawChoice& a, const LawChoice& b, double R2, double x_valid) {
  const Law exact = make_law(a, 1e-3, b, R2), one = like(a), two = like(b);
  const Law joined = tabulate(join(exact.pair, {one.table.get()}, {two.table.get()}));
  for (double x = 1e-4; x < x_valid; x *= 1.07) {
    const double gamma = x / exact.scale.x_per_gamma;
    const Response want = evaluate(exact, State{}, gamma), got = evaluate(joined, State{}, gamma);
    EXPECT_NEAR(got.force, want.force, 1e-4 * want.force) << x << ' ' << R2;
    EXPECT_NEAR(got.contact_radius, want.contact_radius, 1e-4 * want.contact_radius) << x << ' ' << R2;
  }
}

TEST(Joined, ElasticBodiesOfAnyRadiiAndModuliAreHertzs) {
  const LawChoice soft{"hertz", "", parameter_texts("E_Pa=1e9 nu=0.3")},
      hard{"hertz", "", parameter_texts("E_Pa=5e10 nu=0.2")};
  for (double R2 : {1e-3, 3e-3, 0.2e-3, infinity}) {
    expect_same(soft, hard, R2, 0.01);
    expect_same(hard, soft, R2, 0.01);
    expect_same(soft, soft, R2, 0.01);
  }
}

TEST(Joined, HardeningBodiesAreThoseOfTheSimilaritySolution) {
  for (const char* inverse_m : {"0.1", "0.3", "0.7"}) {
    const std::string hardening = std::string(" inverse_m=") + inverse_m;
    const LawChoice soft{"similarity", "", parameter_texts("E_Pa=1e18 nu=0.3 kappa_Pa=1e7" + hardening)},
        hard{"similarity", "", parameter_texts("E_Pa=1e18 nu=0.3 kappa_Pa=3e7" + hardening)};
    for (double R2 : {1e-3, 3e-3, 0.2e-3}) expect_same(soft, hard, R2, 0.03);
  }
}

TEST(Joined, OfEqualBodiesIsTheirCurve) {
  Random random;
  const LawChoice granule = random_material(find_law("pressed"), random);
  const Law alone = like(granule),
            joined = tabulate(join(alone.pair, {alone.table.get()}, {alone.table.get()}));
  for (double x = 1e-3; x < 0.49; x *= 1.1) {
    const double gamma = x / alone.scale.x_per_gamma, F = evaluate(alone, State{}, gamma).force;
    EXPECT_NEAR(evaluate(joined, State{}, gamma).force, F, 1e-3 * F) << x;
  }
}

/// Beside laws that know both moduli, spheres of one radius: docs/explanation/joined.md.
TEST(Joined, IsNearLawsThatKnowBothModuli) {
  const auto metal = [](const std::string& law, const char* E, const char* sigma) {
    const char* strength = law == "thornton-ning" ? " p_y_Pa=" : " sigma_y_Pa=";
    return LawChoice{law, "", parameter_texts(std::string("nu=0.3 E_Pa=") + E + strength + sigma)};
  };
  const struct {
    const char *E, *sigma;
    double agarwal, most, most_from_0_1;
  } second[] = {{"1e9", "1e7", 1e-3, 1e-3, 1e-3},
                {"1e9", "4e7", 2e-3, 2e-3, 2e-3},
                {"5e9", "1e7", 0.045, 0.22, 0.07},
                {"1e12", "1e10", 0.065, 0.29, 0.115}};
  for (const std::string law : {"agarwal", "kogut-etsion", "mdr", "thornton-ning"})
    for (const auto& [E, sigma, of_agarwal, most, most_from_0_1] : second) {
      const LawChoice a = metal(law, "1e9", "1e7"), b = metal(law, E, sigma);
      const Law exact = make_law(a, 1e-3, b, 1e-3), one = like(a), two = like(b);
      const Law joined = tabulate(join(exact.pair, {one.table.get()}, {two.table.get()}));
      for (double x : {1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2, 0.1, 0.3}) {
        const double gamma = x / exact.scale.x_per_gamma, F = evaluate(exact, State{}, gamma).force;
        const double bound = law == "agarwal" ? of_agarwal : x < 0.1 ? most : most_from_0_1;
        EXPECT_NEAR(evaluate(joined, State{}, gamma).force, F, bound * F)
            << law << ' ' << E << ' ' << sigma << ' ' << x;
      }
    }
}

TEST(Joined, OfUnlikeStrengthIsInRangeWhileTheHarderOneSinksInALittle) { // pair.hpp
  const auto metal = [](const char* strength) {
    return LawChoice{
        "pressed", "",
        parameter_texts(std::string("E_Pa=1e10 nu=0.3 delta_bar=1e-3,1e-2,0.1,0.5 F_bar=4e-3,5e-2,0.5,3 "
                                    "a_bar=0.03,0.12,0.45,0.95 sigma_ref_Pa=") +
                        strength)};
  };
  const auto in_range = [&](double R1, double R2, double x) { // the first is the harder one
    const Law law = make_law(metal("1e9"), R1, metal("1e7"), R2);
    return evaluate(law, State{}, x / law.scale.x_per_gamma).in_range;
  };
  for (const double soft : {infinity, 2.0}) {
    EXPECT_TRUE(in_range(0.5, soft, 0.018));
    EXPECT_FALSE(in_range(0.5, soft, 0.022));
  }
  for (const double hard : {infinity, 2.0}) EXPECT_TRUE(in_range(hard, 0.5, 0.3));
  EXPECT_TRUE(in_range(0.5, 0.5, 0.199)); // 0.4 of its radius
  EXPECT_FALSE(in_range(0.5, 0.5, 0.201));
}

TEST(Joined, IsInRangeWhereBothSidesAre) { // similarity begins above Hertz's force
  const LawChoice rigid_plastic{"similarity", "",
                                parameter_texts("E_Pa=1e9 nu=0.3 kappa_Pa=1e7 inverse_m=0.2")},
      elastic{"hertz", "", parameter_texts("E_Pa=1e9 nu=0.3")};
  const Law alone = like(rigid_plastic), law = make_law(rigid_plastic, 1e-3, elastic, 1e-3);
  const double begin = alone.table->valid[0][0];
  ASSERT_GT(begin, 1e-4);
  const auto in_range = [&](double x) { return evaluate(law, State{}, x / law.scale.x_per_gamma).in_range; };
  EXPECT_FALSE(in_range(begin / 2));
  EXPECT_TRUE(in_range(1.1 * begin));
  EXPECT_FALSE(in_range(0.1)); // where hertz ends
}

TEST(Joined, AnyTwoCurvesMakeASoundLaw) {
  Random random;
  for (int i = 0; i < 100; ++i) {
    const LawChoice a = random_material(find_law("pressed"), random),
                    b = random_material(find_law("pressed"), random);
    const double R2 = random.log_between(2e-4, 5e-3);
    const Law law = make_law(a, 1e-3, b, R2), mirrored = make_law(b, R2, a, 1e-3);
    double last = 0;
    const double end = std::min(law.table->valid[0][1], mirrored.table->valid[0][1]);
    for (double x = 1e-5; x < end; x *= 1.2) {
      const double gamma = x / law.scale.x_per_gamma, F = evaluate(law, State{}, gamma).force;
      ASSERT_GE(F, last) << text_of(a) << text_of(b);
      ASSERT_NEAR(evaluate(mirrored, State{}, gamma).force, F, 5e-3 * F); // one walks along a, one along b
      last = F;
    }
  }
}

TEST(Joined, ParticlesPressedInDifferentWaysDoNotMeet) {
  const auto metal = [](const char* loading) {
    return LawChoice{"agarwal", "",
                     parameter_texts(std::string("E_Pa=5e8 nu=0.3 sigma_y_Pa=1e6 loading=") + loading)};
  };
  const LawChoice hertz{"hertz", "", parameter_texts("E_Pa=1e9 nu=0.3")};
  EXPECT_THROW((void)make_law(metal("die"), 1e-3, metal("simple"), 1e-3), BadParameter);
  EXPECT_THROW((void)make_law(metal("die"), 1e-3, hertz, 1e-3), BadParameter);
  EXPECT_NO_THROW((void)make_law(metal("simple"), 1e-3, hertz, 1e-3));
  EXPECT_NO_THROW((void)make_law(metal("die"), 1e-3, metal("die"), 2e-3));
}

TEST(Joined, SpringsOfTheirOwnNeedTheirLike) {
  const LawChoice hertz{"hertz", "", parameter_texts("E_Pa=1e9 nu=0.3")};
  const LawChoice springs{"luding", "", parameter_texts("k_1_N_per_m=1e5 k_2_N_per_m=5e5 phi_f=0.1")};
  EXPECT_THROW((void)make_law(hertz, 1e-3, springs, 1e-3), BadParameter);
}

} // namespace
