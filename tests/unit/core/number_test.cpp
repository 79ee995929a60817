#include "core/number.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace platen::core;

TEST(Number, IsWrittenAsPeopleWriteIt) {
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(1e8), "1e8");
  EXPECT_EQ(number_text(1e-5), "1e-5");
  EXPECT_EQ(number_text(8.61e6), "8610000");
  EXPECT_EQ(number_text(-2.5), "-2.5");
  EXPECT_EQ(number_text(0), "0");
  EXPECT_EQ(number_text(1e100), "1e100");
}

TEST(Number, ReadsBackAsTheSameNumber) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-300, 300), mantissa(-1, 1);
  for (int i = 0; i < 10000; ++i) {
    const double x = mantissa(random) * std::pow(10, exponent(random));
    EXPECT_EQ(number_from(number_text(x)), x);
  }
}

TEST(Number, IsNothingElseThanANumber) {
  for (const char* text : {"", " ", "1 ", "1,5", "0x10", "1e", "--1", "1e999", "ten"})
    EXPECT_FALSE(number_from(text));
  EXPECT_EQ(number_from("+1.5"), 1.5);
}
