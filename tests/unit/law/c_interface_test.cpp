#include "platen_law.h"

#include "platen/law/catalogue.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace {

using namespace platen::law;

const std::array<std::pair<const char*, const char*>, 14> examples = {{
    {"hertz", "radius_m=1e-3 E_Pa=1e9 nu=0.3"},
    {"similarity", "radius_m=1e-3 E_Pa=1e9 nu=0.3 kappa_Pa=1e6 inverse_m=0.3"},
    {"edmans-sinka", "radius_m=1e-3 sigma_ref_Pa=8.61e6 E_Pa=4.417e8 nu=0.1472 k=4.2 delta_t=0.09 a=3.5"},
    {"wang", "radius_m=0.1 E_Pa=1e10 nu=0.15 phi_deg=25 sigma_c_Pa=15e6"},
    {"agarwal", "radius_m=1e-3 E_Pa=5e8 nu=0.3 sigma_y_Pa=1e6 loading=die"},
    {"shahin", "radius_m=1e-3 E_Pa=1e9 nu=0.3 kappa_Pa=1e6 inverse_m=0.3 loading=hydrostatic"},
    {"thornton-ning", "radius_m=1e-3 E_Pa=1e9 nu=0.3 p_y_Pa=1.6e6"},
    {"kogut-etsion", "radius_m=1e-3 E_Pa=1e9 nu=0.3 sigma_y_Pa=1e6"},
    {"etsion-unloading", "radius_m=1e-3 E_Pa=1e9 nu=0.3 sigma_y_Pa=1e6"},
    {"jackson-green", "radius_m=1e-3 E_Pa=1e9 nu=0.3 sigma_y_Pa=1e6"},
    {"mdr", "radius_m=1e-3 E_Pa=1e9 nu=0.3 sigma_y_Pa=1e6"},
    {"luding", "radius_m=1e-3 k_1_N_per_m=1e5 k_2_N_per_m=5e5 phi_f=0.1"},
    {"eepa", "radius_m=1e-3 E_Pa=1e9 nu=0.3 lambda_p=0.6"},
    {"pressed",
     "radius_m=1e-3 E_Pa=2e9 nu=0.3 sigma_ref_Pa=1e7 delta_bar=1e-4,1e-3,1e-2,0.05,0.1,0.2,0.35,0.5 "
     "F_bar=6e-5,1.6e-3,0.035,0.22,0.48,1.1,2.2,4 a_bar=0.009,0.03,0.13,0.32,0.46,0.66,0.85,1"},
}};

TEST(Catalogue, HasAnExampleOfEachLaw) {
  ASSERT_EQ(examples.size(), laws().size());
  for (std::size_t i = 0; i < examples.size(); ++i) EXPECT_EQ(examples[i].first, laws()[i].name);
}

TEST(CInterface, GivesWhatTheHeadersGive) {
  for (const auto& [name, parameters] : examples) {
    char why[200] = "";
    platen_law* law = platen_law_new(name, "", parameters, why, sizeof why);
    ASSERT_NE(law, nullptr) << why;
    const Law same = make_law(name, "", parameter_texts(parameters));
    ASSERT_EQ(platen_law_state_size(law), sizeof(State));
    EXPECT_EQ(platen_law_state_version(law), state_version);
    EXPECT_STREQ(platen_law_state_name(law, 1), "gamma_max [m]");
    EXPECT_EQ(platen_law_state_name(law, 2), nullptr);
    std::array<double, 2> c{};
    State s;
    for (double x : {1e-7, 1e-4, 2e-4, 1.9e-4, 1e-5, 1.99e-4, 3e-4}) {
      const platen_law_response got = platen_law_evaluate(law, c.data(), x);
      const Response want = evaluate(same, s, x);
      EXPECT_EQ(got.force_N, want.force) << name;
      EXPECT_EQ(got.dissipated_work_J, want.dissipated_work);
      EXPECT_EQ(got.branch, static_cast<int>(want.branch));
      s = want.state;
    }
    platen_law_free(law);
  }
}

/// Contacts that load, unload, part, never touch, are no number or were never left so.
TEST(CInterface, SaysOfManyContactsWhatItSaysOfEach) {
  constexpr std::size_t n = 100;
  for (const auto& [name, parameters] : examples) {
    platen_law* law = platen_law_new(name, "", parameters, nullptr, 0);
    ASSERT_NE(law, nullptr);
    std::array<State, n> all{}, each{};
    all[70] = each[70] = {0, -1e-5};
    for (int turn = 0; turn < 4; ++turn) {
      std::array<double, n> overlap, force, stiffness, force_alone;
      for (std::size_t i = 0; i < n; ++i)
        overlap[i] = i == 3 ? std::nan("") : 3e-4 * std::sin(static_cast<double>(i) + turn);
      std::array<State, n> again = all;
      platen_law_evaluate_all(law, n, overlap.data(), again.data(), force_alone.data(), nullptr);
      platen_law_evaluate_all(law, n, overlap.data(), all.data(), force.data(), stiffness.data());
      for (std::size_t i = 0; i < n; ++i) {
        const auto want = platen_law_evaluate(law, &each[i], overlap[i]);
        if (std::isnan(want.force_N)) {
          EXPECT_TRUE(std::isnan(force[i]) && std::isnan(force_alone[i])) << name << ' ' << i;
        } else {
          EXPECT_NEAR(force[i], want.force_N, 1e-11 * want.force_N) << name << ' ' << i;
          EXPECT_NEAR(force_alone[i], want.force_N, 1e-11 * want.force_N) << name << ' ' << i;
          EXPECT_NEAR(stiffness[i], want.stiffness_N_per_m, 1e-10 * want.stiffness_N_per_m) << name;
        }
        EXPECT_EQ(all[i].gamma_max, each[i].gamma_max) << name << ' ' << i;
        EXPECT_EQ(all[i].gamma, each[i].gamma) << name << ' ' << i;
        EXPECT_EQ(again[i].gamma_max, each[i].gamma_max) << name << ' ' << i;
      }
    }
    platen_law_free(law);
  }
}

TEST(CInterface, OfBytesThatAreNoStateSaysSo) { // an infinite overlap once read beyond the table
  for (const auto& [name, parameters] : examples) {
    platen_law* law = platen_law_new(name, "", parameters, nullptr, 0);
    ASSERT_NE(law, nullptr);
    for (const double top : {double(infinity), 1e305, std::nan(""), -1e-5}) {
      double state[2] = {0, top};
      const platen_law_response now = platen_law_evaluate(law, state, 1e-5);
      EXPECT_TRUE(std::isnan(now.force_N) && !now.in_range) << name << ' ' << top;
      if (!std::isnan(top)) { EXPECT_EQ(state[1], top); }
    }
    platen_law_free(law);
  }
}

TEST(CInterface, SaysWhatIsWrong) {
  char why[200] = "";
  EXPECT_EQ(platen_law_new("hertzz", "", "", why, sizeof why), nullptr);
  EXPECT_STREQ(why,
               "there is no law 'hertzz'; known are: hertz, similarity, edmans-sinka, wang, agarwal, shahin, "
               "thornton-ning, kogut-etsion, etsion-unloading, jackson-green, mdr, luding, eepa, pressed");
  EXPECT_EQ(platen_law_new("hertz", "", "radius_m=1e-3 E_Pa=1e9 nu=0.5", why, sizeof why), nullptr);
  EXPECT_STREQ(why, "hertz: nu = 0.5 is not in [0, 0.5)");
  EXPECT_EQ(platen_law_new("hertz", "", "radius_m=1e-3 E_MPa=1", why, sizeof why), nullptr);
  EXPECT_NE(std::string(why).find("there is no parameter 'E_MPa'"), std::string::npos);
  EXPECT_EQ(platen_law_new("agarwal", "publshed", "", why, sizeof why), nullptr);
  EXPECT_STREQ(why, "agarwal: there is no variant 'publshed'; known are: hertz-radius, published");
  EXPECT_EQ(platen_law_new("hertz", nullptr, nullptr, nullptr, 0), nullptr); // and does not crash
  char tiny[4];
  EXPECT_EQ(platen_law_new("x", "", "", tiny, sizeof tiny), nullptr);
  EXPECT_STREQ(tiny, "the");
}

TEST(Catalogue, RefusesWhatNoLawHereCanBe) {
  const auto why = [](const char* name, const char* parameters) -> std::string {
    try {
      (void)make_law(name, "", parameter_texts(parameters));
    } catch (const BadParameter& error) { return error.what(); }
    return "";
  };
  const auto says = [&](const char* name, const char* parameters, const char* words) {
    EXPECT_NE(why(name, parameters).find(words), std::string::npos) << why(name, parameters);
  };
  says("hertz", "radius_m=1e-3 E_Pa=1e9 nu=0.3 surface_energy=0.1", "no law here has adhesion");
  says("shahin", "radius_m=1e-3 E_Pa=5e6 nu=0.3 kappa_Pa=6e6 inverse_m=0.3", "stays elastic");
  says("similarity", "radius_m=1e-3 E_Pa=5e6 nu=0.3 kappa_Pa=6e6 inverse_m=0.3", "stays elastic");
  says("hertz", "radius_m=1e-3 E_Pa=1e9 nu=nan", "not a number");
  says("hertz", "radius_m=1e-3 radius2_m=2e-3 E_Pa=1e9 nu=0.3 against=plane",
       "radius2_m has no meaning against a rigid plane");
  says("wang", "radius_m=1e-3 E_Pa=2e11 nu=0.3 phi_deg=30 sigma_c_Pa=1e9",
       "Table 2 has no law for this rock");
  says("pressed", "radius_m=1e-3 E_Pa=1e9 nu=0.3 sigma_ref_Pa=1e6 delta_bar=1,2 F_bar=1,2 a_bar=1,2",
       "delta_bar");
}

TEST(Catalogue, TakesMetalsOfAnyStrength) { // tables once ended at E/sigma_y of about 27,000, without a word
  for (const char* law : {"agarwal", "jackson-green", "mdr", "kogut-etsion"})
    for (const char* strength : {"1e7", "1e5", "1e3"}) {
      const Law metal = make_law(
          law, "", parameter_texts(std::string("radius_m=1e-3 E_Pa=1e11 nu=0.3 sigma_y_Pa=") + strength));
      double last = 0;
      for (double gamma = 1e-12; gamma < 1e-3; gamma *= 1.5) {
        const Response now = evaluate(metal, State{}, gamma);
        ASSERT_TRUE(std::isfinite(now.force) && now.force >= last) << law << ' ' << strength << ' ' << gamma;
        if (std::string_view(law) == "agarwal") { ASSERT_LT(now.contact_radius, 2.1e-3); }
        last = now.force;
      }
    }
}

TEST(Catalogue, EveryLawIsMadeInEveryVariantAndAgainstAPlane) {
  for (const auto& [name, parameters] : examples) {
    auto texts = parameter_texts(parameters);
    const double springs = std::string_view(name) == "luding" ? 2 : 1; // the spring is that of the pair
    if (std::string_view(name) == "wang")
      texts["a"] = "1.05", texts["b"] = "1.45", texts["m"] = "1.2", texts["n"] = "1.48";
    for (const auto& variant : detail::split(find_law(name).variants, '|')) {
      texts.erase("against");
      const Law two = make_law(name, variant, texts);
      texts["against"] = "plane";
      const Law wall = make_law(name, variant, texts);
      const double delta = 0.01 / wall.scale.x_per_gamma;
      const double F = evaluate(wall, State{}, delta).force;
      EXPECT_GT(F, 0);
      EXPECT_NEAR(evaluate(two, State{}, 2 * delta).force, springs * F, 1e-9 * F)
          << name << ' ' << variant; // the mirror
    }
  }
}

} // namespace
