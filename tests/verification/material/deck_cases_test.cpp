// Material sections of Abaqus input files with known counterparts (tests/data/measured/README.md).

#include "core/file.hpp"
#include "material/card.hpp"
#include "material/deck.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace platen;
using namespace platen::material;

Converted converted(const std::string& file, const std::string& units) {
  const auto decks = read_deck(core::read_file(PLATEN_MEASURED + file), file);
  EXPECT_EQ(decks.size(), 1u);
  return convert(decks.front(), deck_units(units));
}

bool lists(const Converted& c, std::string_view part) {
  for (const auto& line : c.left_over)
    if (line.find(part) != std::string::npos) return true;
  return false;
}

void expect_close(double found, double truth) { EXPECT_NEAR(found, truth, 0.005 * truth); }

TEST(DeckCases, ACapModelOverRelativeDensity) {
  const auto c = converted("s11_excipient_cap.inp", "mm-tonne-MPa");
  const auto& m = std::get<Dpc>(c.material.model);
  EXPECT_DOUBLE_EQ(m.rho_r0, 0.45);
  expect_close(m.sigma_y, 9.0e6);
  expect_close(m.E, 520e6);
  expect_close(m.nu, 0.12);
  expect_close(m.Gamma, 7.2e6);
  expect_close(m.Lambda, 1.1e6);
  expect_close(m.epsilon, 0.42);
  expect_close(m.eta, 6.4);
  expect_close(m.xi, 5.1);
  expect_close(m.zeta, 5.6);
  expect_close(m.omega, 6.0);
  expect_close(m.xi_1, 0.35);
  expect_close(m.xi_2, 0.5);
  EXPECT_DOUBLE_EQ(c.material.density.value_or(0), 690);
  EXPECT_TRUE(lists(c, "*DEPVAR"));
  EXPECT_TRUE(lists(c, "*USER DEFINED FIELD"));
}

TEST(DeckCases, DruckerPragerByCompression) {
  const auto c = converted("s12_rock_dp_si.inp", "si");
  const auto& m = std::get<DruckerPrager>(c.material.model);
  EXPECT_DOUBLE_EQ(m.E, 18e9);
  EXPECT_DOUBLE_EQ(m.nu, 0.21);
  EXPECT_DOUBLE_EQ(m.beta_deg, 44.2);
  EXPECT_DOUBLE_EQ(m.psi_deg, 12.5);
  EXPECT_DOUBLE_EQ(m.sigma_c, 36e6);
  EXPECT_NEAR(m.surface(0).d, 24.33e6, 0.01e6);
  EXPECT_DOUBLE_EQ(c.material.density.value_or(0), 2640);
}

TEST(DeckCases, AHardeningTableOfLead) {
  const auto c = converted("s13_lead_plastic.inp", "mm-tonne-MPa");
  const auto& m = std::get<VonMises>(c.material.model);
  const auto& table = std::get<HardeningTable>(m.hardening);
  ASSERT_EQ(table.size, 5);
  const double strain[] = {0, 0.02, 0.06, 0.2, 0.6}, stress[] = {5.2e6, 8.1e6, 10.35e6, 13.9e6, 18.6e6};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_DOUBLE_EQ(table.strain[i], strain[i]);
    EXPECT_DOUBLE_EQ(table.stress[i], stress[i]);
  }
  EXPECT_DOUBLE_EQ(m.E, 16e9);
  EXPECT_DOUBLE_EQ(m.nu, 0.44);
  EXPECT_DOUBLE_EQ(c.material.density.value_or(0), 11340);
  EXPECT_TRUE(lists(c, "*EXPANSION"));
}

TEST(DeckCases, MohrCoulombWithACutOff) {
  const auto c = converted("s14_sandstone_mc.inp", "mm-tonne-MPa");
  const auto& m = std::get<MohrCoulomb>(c.material.model);
  EXPECT_DOUBLE_EQ(m.phi_deg, 33);
  EXPECT_DOUBLE_EQ(m.psi_deg, 8);
  EXPECT_DOUBLE_EQ(m.cohesion, 7.9e6);
  EXPECT_DOUBLE_EQ(m.cutoff, 2.4e6);
  EXPECT_DOUBLE_EQ(m.E, 12.5e9);
  EXPECT_DOUBLE_EQ(m.nu, 0.24);
  EXPECT_TRUE(lists(c, "flow potential"));
}

TEST(DeckCases, ThereAndBackGivesTheSameMaterial) {
  for (const auto& [file, units] :
       {std::pair{"s11_excipient_cap.inp", "mm-tonne-MPa"}, std::pair{"s12_rock_dp_si.inp", "si"},
        std::pair{"s13_lead_plastic.inp", "mm-tonne-MPa"},
        std::pair{"s14_sandstone_mc.inp", "mm-tonne-MPa"}}) {
    const auto there = converted(file, units).material;
    for (const auto& other : deck_units()) {
      const auto text = deck_of(there, other).text;
      const auto back = convert(read_deck(text, "back").front(), other).material;
      EXPECT_EQ(back.name, there.name);
      const auto a = parameters(there), b = parameters(back);
      ASSERT_EQ(a.size(), b.size());
      for (std::size_t i = 0; i < a.size(); ++i)
        EXPECT_NEAR(b[i].value, a[i].value, 1e-4 * std::abs(a[i].value)) << file << " " << a[i].key;
    }
  }
}

} // namespace
