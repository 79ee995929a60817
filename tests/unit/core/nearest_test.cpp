#include "core/nearest.hpp"

#include <gtest/gtest.h>

#include <vector>

using namespace platen::core;

TEST(Nearest, FindsTheKeyThatWasMeant) {
  const std::vector<std::string> known = {"sigma_y_Pa", "E_Pa", "nu", "epsilon"};
  EXPECT_EQ(nearest("sigmay_Pa", known), "sigma_y_Pa");
  EXPECT_EQ(nearest("NU", known), "nu");
  EXPECT_EQ(nearest("un", known), "nu");
  EXPECT_EQ(nearest("espilon", known), "epsilon");
}

TEST(Nearest, SuggestsNothingForAnotherWordAndListsWhatThereIs) {
  const std::vector<std::string> known = {"nu", "E_Pa"};
  EXPECT_EQ(nearest("temperature", known), "");
  EXPECT_EQ(suggestion("temperature", known), "; known are: nu, E_Pa");
  EXPECT_EQ(nearest(std::string(100000, 'x'), known), "");
}

TEST(Nearest, CountsASwapOfNeighboursAsOneEdit) { EXPECT_EQ(edit_distance("theta", "hteta"), 1); }
