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
