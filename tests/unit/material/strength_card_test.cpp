// What a card says of hardening and of friction, and what it must not say.

#include "material/card.hpp"

#include "core/error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace platen;
using namespace platen::material;

namespace {

material::Material read(const std::string& model, const std::string& lines) {
  const std::string text = "platen = 1\nname = \"x\"\nmodel = \"" + model + "\"\n[parameters]\n" + lines;
  return read_card(core::parse_toml(text, "m.toml")).material;
}

std::string refusal(const std::string& model, const std::string& lines) {
  try {
    (void)read(model, lines);
  } catch (const core::InvalidInput& error) { return error.what(); }
  return "nothing was refused";
}

void refuses(const std::string& model, const std::string& lines, const std::string& rule) {
  EXPECT_NE(refusal(model, lines).find(rule), std::string::npos) << lines << "\n" << refusal(model, lines);
}

const std::string metal = "E_Pa = 10e9\nnu = 0.435\n";
const std::string rock = "E_Pa = 10e9\nnu = 0.38\n";

} // namespace

TEST(HardeningCard, ReadsEveryKind) {
  const auto law = [](const std::string& lines) {
    return std::get<VonMises>(read("von-mises", metal + lines).model);
  };
  EXPECT_TRUE(std::holds_alternative<PerfectlyPlastic>(law("sigma_y_Pa = 5e6").hardening));
  EXPECT_TRUE(std::holds_alternative<PerfectlyPlastic>(
      law("sigma_y_Pa = 5e6\nhardening = { kind = \"none\" }").hardening));
  EXPECT_EQ(std::get<ExponentialHardening>(
                law("sigma_y_Pa = 5e6\nhardening = { kind = \"exponential\", eta = 2 }").hardening)
                .eta,
            2);
  const VonMises lead = law("hardening = { kind = \"hollomon\", kappa_Pa = 20.5e6, inverse_m = 0.24 }");
  EXPECT_NEAR(lead.sigma_y, 10e9 * std::pow(20.5e6 / 10e9, 1 / 0.76), 1);
  EXPECT_EQ(reference_stress(lead), 20.5e6);
  const auto ludwik = std::get<Ludwik>(
      law("sigma_y_Pa = 5e6\nhardening = { kind = \"ludwik\", K_Pa = 15.5e6, inverse_n = 0.35 }").hardening);
  EXPECT_EQ(ludwik.K, 15.5e6);
  EXPECT_EQ(ludwik.inverse_n, 0.35);
  const VonMises table = law("hardening = { kind = \"table\", strain = [0, 0.1], stress_Pa = [5e6, 9e6] }");
  EXPECT_EQ(table.sigma_y, 5e6);
}

TEST(HardeningCard, IsWrittenAsItIsRead) {
  for (const std::string lines :
       {"sigma_y_Pa = 5e6\nhardening = { kind = \"ludwik\", K_Pa = 15.5e6, inverse_n = 0.35 }",
        "hardening = { kind = \"hollomon\", kappa_Pa = 20.5e6, inverse_m = 0.24 }",
        "sigma_y_Pa = 5e6\nhardening = { kind = \"exponential\", eta = -0.1 }",
        "hardening = { kind = \"table\", strain = [0, 0.1, 0.7], stress_Pa = [5e6, 9e6, 8e6] }"}) {
    const auto first = read("von-mises", metal + lines);
    const auto again = read_card(core::parse_toml(card_text(first), "again.toml")).material;
    EXPECT_EQ(card_text(again), card_text(first));
    const auto before = parameters(first.model), after = parameters(again.model);
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i)
      EXPECT_EQ(after[i].value, before[i].value) << before[i].key;
  }
}

TEST(HardeningCard, RefusesWhatIsNoHardening) {
  const auto hardening = [](const std::string& law) {
    return metal + "sigma_y_Pa = 5e6\nhardening = " + law;
  };
  refuses("von-mises", hardening("{ kind = \"ludwick\" }"), "did you mean 'ludwik'?");
  refuses("von-mises", hardening("{ K_Pa = 1 }"), "kind is missing");
  refuses("von-mises", hardening("\"ludwik\""), "must be a section");
  refuses("von-mises", hardening("{ kind = \"ludwik\", K_Pa = 1e6, inverse_n = 0 }"), "a number > 0");
  refuses("von-mises", hardening("{ kind = \"ludwik\", K_Pa = 1e6, inverse_n = -0.3 }"), "a number > 0");
  refuses("von-mises", hardening("{ kind = \"ludwik\", K_Pa = 1e11, inverse_n = 0.3 }"),
          "must be less than E_Pa");
  refuses("von-mises", hardening("{ kind = \"hollomon\", kappa_Pa = 1e6, inverse_m = 0.3 }"),
          "has its own yield stress");
  refuses("von-mises", hardening("{ kind = \"exponential\", eta = -1e4 }"), "must stay above -3G");
  refuses("von-mises", metal + "hardening = { kind = \"hollomon\", kappa_Pa = 1e6, inverse_m = 1.1 }",
          "(0, 1]");
  const auto table = [](const std::string& points) {
    return metal + "hardening = { kind = \"table\", " + points + " }";
  };
  refuses("von-mises", table("strain = [-0.1, 0.1], stress_Pa = [5e6, 9e6]"), "numbers >= 0");
  refuses("von-mises", table("strain = [0, 0.2, 0.1], stress_Pa = [5e6, 9e6, 9e6]"),
          "greater than the one before");
  refuses("von-mises", table("strain = [0.1, 0.2], stress_Pa = [5e6, 9e6]"), "begins at strain 0");
  refuses("von-mises", table("strain = [0, 0.2], stress_Pa = [5e6]"), "each strain needs its stress");
  refuses("von-mises", table("strain = [0], stress_Pa = [5e6]"), "two points");
  refuses("von-mises", table("strain = [0, 1e-6], stress_Pa = [5e6, 1e5]"), "must stay above -3G");
}

TEST(DruckerPragerCard, IsGivenInThreeWays) {
  const auto model = [](const std::string& lines) {
    return std::get<DruckerPrager>(read("drucker-prager", rock + lines).model);
  };
  // WG section 3.4: the same rock by beta, by phi and sigma_c, by phi and C (C printed to two figures).
  const auto by_beta = model("beta_deg = 47.84\nsigma_c_Pa = 10.61e6");
  const auto by_phi = model("phi_deg = 27.8\nsigma_c_Pa = 10.61e6");
  const auto by_cohesion = model("phi_deg = 27.8\ncohesion_Pa = 3.2e6");
  EXPECT_NEAR(by_phi.beta_deg, by_beta.beta_deg, 0.01);
  EXPECT_EQ(by_cohesion.beta_deg, by_phi.beta_deg);
  EXPECT_NEAR(by_cohesion.sigma_c, 10.61e6, 0.01e6);
  EXPECT_EQ(by_beta.psi_deg, by_beta.beta_deg);
  EXPECT_EQ(model("beta_deg = 47.84\nsigma_c_Pa = 10.61e6\npsi_deg = 0").psi_deg, 0);
}

TEST(DruckerPragerCard, KnowsTheAngleOfFrictionThatItWasGiven) {
  for (const double phi : {25.0, 27.8, 30.0, 33.33, 0.1, 89.0}) {
    const DruckerPrager m{10e9, 0.38, DruckerPrager::beta_of_friction(phi), 1e6, 0};
    EXPECT_EQ(m.friction_deg(), phi);
  }
  const DruckerPrager by_beta{10e9, 0.38, 47.84, 1e6, 0}; // WG section 3.4: phi = 27.8 in three digits
  EXPECT_NEAR(DruckerPrager::beta_of_friction(by_beta.friction_deg()), 47.84, 1e-12);
}

TEST(DruckerPragerCard, RefusesWhatIsNoFriction) {
  refuses("drucker-prager", rock + "beta_deg = 47\nphi_deg = 27\nsigma_c_Pa = 1e6", "exactly one of");
  refuses("drucker-prager", rock + "beta_deg = 47\ncohesion_Pa = 1e6", "exactly one of");
  refuses("drucker-prager", rock + "phi_deg = 27\nsigma_c_Pa = 1e6\ncohesion_Pa = 1e6", "exactly one of");
  refuses("drucker-prager", rock + "sigma_c_Pa = 1e6", "exactly one of");
  refuses("drucker-prager", rock + "phi_deg = 90\nsigma_c_Pa = 1e6", "in (0, 90)");
  refuses("drucker-prager", rock + "phi_deg = 0\nsigma_c_Pa = 1e6", "in (0, 90)");
  refuses("drucker-prager", rock + "beta_deg = 72\nsigma_c_Pa = 1e6", "in (0, 71.5");
  refuses("drucker-prager", rock + "phi_deg = 27\nsigma_c_Pa = 1e6\npsi_deg = 60",
          "exceeds the friction angle");
}

TEST(MohrCoulombCard, IsGivenByCohesionOrStrength) {
  const std::string cut = "phi_deg = 27.8\ntension_cutoff_Pa = 1e6\n";
  const auto by_cohesion =
      std::get<MohrCoulomb>(read("mohr-coulomb", rock + cut + "cohesion_Pa = 3.2e6").model);
  const auto by_strength =
      std::get<MohrCoulomb>(read("mohr-coulomb", rock + cut + "sigma_c_Pa = 10.61e6").model);
  EXPECT_NEAR(by_strength.cohesion, by_cohesion.cohesion, 0.005e6); // WG section 3.4 prints 3.2 MPa
  EXPECT_EQ(by_cohesion.psi_deg, 27.8);
}

TEST(MohrCoulombCard, RefusesWhatIsNoFriction) {
  const std::string cut = rock + "tension_cutoff_Pa = 1e6\n";
  refuses("mohr-coulomb", cut + "phi_deg = 90\ncohesion_Pa = 3.2e6", "in [0, 90)");
  refuses("mohr-coulomb", cut + "phi_deg = 27.8", "exactly one of");
  refuses("mohr-coulomb", cut + "phi_deg = 27.8\ncohesion_Pa = 3.2e6\nsigma_c_Pa = 1e7", "exactly one of");
  refuses("mohr-coulomb", cut + "phi_deg = 27.8\ncohesion_Pa = 3.2e6\npsi_deg = 30", "exceeds phi_deg");
  refuses("mohr-coulomb", rock + "phi_deg = 27.8\ncohesion_Pa = 3.2e6\ntension_cutoff_Pa = 7e6",
          "not below the apex");
}

TEST(DpcCard, RefusesACapInsideItsFailureLine) {
  const std::string card = card_text(read_card("base-case").material);
  const auto at = card.find("[parameters]");
  std::string lines = card.substr(at + 13);
  EXPECT_FALSE(std::get<Dpc>(read("dpc", lines).model).published_flow);
  const auto published = read("dpc", lines + "published_flow = true\n");
  EXPECT_TRUE(std::get<Dpc>(published.model).published_flow);
  EXPECT_TRUE(std::get<Dpc>(read_card(core::parse_toml(card_text(published), "again")).material.model)
                  .published_flow);
  lines.replace(lines.find("epsilon = 0.7"), 13, "epsilon = 1.0");
  refuses("dpc", lines, "inside the failure line");
}

TEST(RunAs, TurnsAPorousMaterialIntoItsEquivalents) {
  const auto base = read_card("base-case").material;
  EXPECT_FALSE(std::get<Dpc>(run_as(base.model, "dpc")).published_flow);
  EXPECT_TRUE(std::get<Dpc>(run_as(base.model, "dpc-published")).published_flow);
  EXPECT_EQ(model_name(run_as(run_as(base.model, "dpc"), "vmdc")), "vmdc");
  EXPECT_EQ(std::get<VonMises>(run_as(base.model, "von-mises")).sigma_y, 150e6);
  EXPECT_THROW((void)run_as(base.model, "drucker-prager"), core::InvalidInput);
  EXPECT_THROW((void)run_as(VonMises{1, 0.3, 1}, "dpc"), core::InvalidInput);
  auto blunt = std::get<Vmdc>(base.model);
  blunt.epsilon = 1;
  EXPECT_THROW((void)run_as(blunt, "dpc"), core::InvalidInput);
}
