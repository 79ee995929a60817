#include "core/error.hpp"
#include "material/deck.hpp"

#include <gtest/gtest.h>

namespace {

using namespace platen;
using namespace platen::material;

Converted from(const std::string& text, const std::string& units = "si", std::optional<double> rho_r0 = {}) {
  return convert(read_deck(text, "a.inp").front(), deck_units(units), rho_r0);
}

std::string refusal(const std::string& text) {
  try {
    (void)from(text);
  } catch (const core::InvalidInput& error) { return error.what(); }
  return "";
}

TEST(Deck, KeywordsInAnyCaseOverSeveralLinesWithRemarks) {
  const auto decks =
      read_deck("** a remark\n*Heading\nx\n*MATERIAL,\nNAME=Steel one\n*elastic, type=ISOTROPIC\n"
                " 2.1d11 , .3\n*Step\n*Plastic\n1,0\n",
                "a.inp");
  ASSERT_EQ(decks.size(), 1u);
  EXPECT_EQ(decks.front().name, "Steel one");
  EXPECT_EQ(decks.front().keywords.size(), 1u) << "a step is no material";
  const auto c = convert(decks.front(), deck_units("si"));
  EXPECT_DOUBLE_EQ(std::get<Elastic>(c.material.model).E, 2.1e11);
}

TEST(Deck, ANameInQuotesKeepsItsCommas) {
  EXPECT_EQ(read_deck("*Material, name=\"lead, 99 %\"\n*Elastic\n1e9,0.3\n", "a.inp").front().name,
            "lead, 99 %");
}

TEST(Deck, AngleInRadiansIsRefusedWithTheAngleItWouldBe) {
  const auto why = refusal(
      "*MATERIAL\n*ELASTIC\n1e9,0.2\n*DRUCKER PRAGER\n0.7714,1,0.2\n*DRUCKER PRAGER HARDENING\n1e6,0\n");
  EXPECT_NE(why.find("as radians it would be 44.2"), std::string::npos) << why;
}

TEST(Deck, TextInPlaceOfANumberIsNamedByLine) {
  EXPECT_EQ(refusal("*MATERIAL\n*ELASTIC\n2e9, abc\n"), "a.inp, line 3, *ELASTIC: \"abc\" is not a number");
}

TEST(Deck, WhatIsMissingIsNamed) {
  EXPECT_EQ(refusal("*MATERIAL\n*ELASTIC\n2e9\n"), "a.inp, line 2, *ELASTIC: its Poisson's ratio is missing");
  EXPECT_NE(refusal("*NODE\n1,0,0,0\n").find("no *MATERIAL"), std::string::npos);
  EXPECT_NE(refusal("*MATERIAL, NAME=M\n*PLASTIC\n1e6,0\n").find("has no *ELASTIC"), std::string::npos);
}

TEST(Deck, StrengthByTensionAndShearGivesTheSameLine) {
  // d = (1 - tan(beta)/3) sigma_c = (1 + tan(beta)/3) sigma_t = sqrt(3) tau with K = 1 (Abaqus, linear model)
  const std::string head =
      "*MATERIAL\n*ELASTIC\n1e9,0.2\n*DRUCKER PRAGER\n45,1,0\n*DRUCKER PRAGER HARDENING, TYPE=";
  const double sigma_c = std::get<DruckerPrager>(from(head + "COMPRESSION\n3e6,0\n").material.model).sigma_c;
  EXPECT_DOUBLE_EQ(sigma_c, 3e6);
  EXPECT_NEAR(std::get<DruckerPrager>(from(head + "TENSION\n1.5e6,0\n").material.model).sigma_c, 3e6, 10);
  EXPECT_NEAR(std::get<DruckerPrager>(from(head + "SHEAR\n1154700.5,0\n").material.model).sigma_c, 3e6, 10);
}

TEST(Deck, SectionOfDruckerPrager) {
  // In extension t = q/K: d = (1/K + tan(beta)/3) sigma_t (Abaqus, linear model).
  const auto deck = [](const std::string& K) {
    return "*MATERIAL\n*ELASTIC\n1e9,0.2\n*DRUCKER PRAGER\n45," + K +
           ",0\n*DRUCKER PRAGER HARDENING, TYPE=TENSION\n1e6,0\n";
  };
  const auto m = std::get<DruckerPrager>(from(deck("0.8")).material.model);
  EXPECT_DOUBLE_EQ(m.flow_stress_ratio, 0.8);
  EXPECT_NEAR(m.surface(0).d, (1 / 0.8 + 1.0 / 3) * 1e6, 10);
  EXPECT_NE(refusal(deck("0.7")).find("K = 0.7: it must be in [7/9, 1]"), std::string::npos);
  const auto back = from(deck_of({"rock", m}, deck_units("si")).text);
  EXPECT_DOUBLE_EQ(std::get<DruckerPrager>(back.material.model).flow_stress_ratio, 0.8);
}

TEST(Deck, AnotherTemperatureIsListedAndNotTaken) {
  const auto c =
      from("*MATERIAL\n*ELASTIC\n1e9,0.2,20\n5e8,0.2,200\n*PLASTIC\n1e6,0,20\n2e6,0.1,20\n5e5,0,200\n");
  EXPECT_EQ(std::get<HardeningTable>(std::get<VonMises>(c.material.model).hardening).size, 2);
  EXPECT_EQ(c.left_over.size(), 2u);
}

TEST(Deck, UnitsAreAskedForWithWhatEachWouldGive) {
  const auto deck = read_deck("*MATERIAL\n*DENSITY\n7.8e-9\n*ELASTIC\n210000,0.3\n", "a.inp").front();
  EXPECT_NE(which_units(deck).find("mm-tonne-MPa: E = 2.1e+11 Pa, density 7800 kg/m3"), std::string::npos);
}

} // namespace
