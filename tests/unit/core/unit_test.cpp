#include "core/unit.hpp"

#include "core/error.hpp"

#include <gtest/gtest.h>

using namespace platen;

TEST(Unit, OfOneKeyInAnother) {
  EXPECT_EQ(core::in_units_of("material.E_Pa", "E_MPa"), 1e6);
  EXPECT_EQ(core::in_units_of("material.E_Pa", "E_Pa"), 1);
  EXPECT_EQ(core::in_units_of("material.nu", "nu"), 1);
  EXPECT_DOUBLE_EQ(core::in_units_of("radius_m", "diameter_mm"), 1e-3);
  EXPECT_EQ(core::in_units_of("material.hardening.inverse_m", "inverse_m"), 1); // no length, in either
}

TEST(Unit, OfAnotherQuantityIsRefused) {
  EXPECT_THROW(core::in_units_of("material.E_Pa", "E"), core::InvalidInput);
  EXPECT_THROW(core::in_units_of("material.nu", "E_MPa"), core::InvalidInput);
  EXPECT_THROW(core::in_units_of("material.E_Pa", "radius_mm"), core::InvalidInput);
}

TEST(Unit, IsReadBesideItsNumber) {
  const auto in_si = [](std::string_view text, std::string_view si) {
    const auto q = core::quantity_from(text);
    return q && q->si == si ? q->in_si : -1;
  };
  EXPECT_EQ(in_si("2 GPa", "Pa"), 2e9);
  EXPECT_EQ(in_si("2e-3GPa", "Pa"), 2e6);
  EXPECT_EQ(in_si("25 N/mm^2", "Pa"), 25e6);
  EXPECT_EQ(in_si("1.1 mm", "m"), 1.1e-3); // to the last digit
  EXPECT_EQ(in_si("0.4 \u00b5m/N", "m_per_N"), 0.4e-6);
  EXPECT_EQ(in_si("2.7 g/cm\u00b3", "kg_per_m3"), 2700);
  EXPECT_EQ(in_si("3 kN/mm", "N_per_m"), 3e6);
  EXPECT_EQ(in_si("30\u00b0", "deg"), 30);
  EXPECT_EQ(in_si("5 mN", "N"), 5e-3);
  EXPECT_EQ(in_si("5 MN", "N"), 5e6); // case matters
  for (const char* none : {"2", "GPa", "2 Gpa", "2,5 GPa", "", "nan m", "2 mm mm", "2 /mm", "hollomon"})
    EXPECT_FALSE(core::quantity_from(none)) << none;
}

TEST(Unit, StandsForAKeyOnlyWhereItMeasuresTheSame) {
  const std::vector<std::string> known = {"E_Pa", "radius_m", "inverse_m", "unload_from", "unload_from_N"};
  EXPECT_EQ(core::si_key("E", known), "E_Pa");
  EXPECT_EQ(core::si_key("inverse", known), "") << "1/m is no length";
  EXPECT_THROW((void)core::value_in_si("E", "2 mm", "E_Pa"), core::InvalidInput);
  const auto table = core::in_si(
      core::parse_toml("E = \"2 GPa\"\nradius_m = 1\nunload_from = [\"1 N\", \"2 kN\"]", "t"), known);
  EXPECT_EQ(std::get<double>(table->find("E_Pa")->data), 2e9);
  EXPECT_FALSE(table->find("E"));
  EXPECT_EQ(std::get<std::vector<core::Value>>(table->find("unload_from_N")->data).size(), 2U);
  EXPECT_THROW((void)core::in_si(core::parse_toml("E = \"2 GPa\"\nE_Pa = 2e9", "t"), known),
               core::InvalidInput);
  EXPECT_FALSE(core::in_si(core::parse_toml("unload_from = [0.1, 0.2]", "t"), known));
}
