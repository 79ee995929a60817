#include "press/result.hpp"

#include <gtest/gtest.h>

#include <array>

using namespace platen;
using press::prevailing;
using enum press::Zone;

TEST(Prevailing, IsTheZoneOfMostPoints) {
  EXPECT_EQ(prevailing(std::array{elastic, elastic, elastic, tension}), elastic);
  EXPECT_EQ(prevailing(std::array{elastic, shear, shear, tension}), shear);
  EXPECT_EQ(prevailing(std::array{compaction}), compaction);
}

TEST(Prevailing, OfEquallyManyIsTheLaterOne) {
  EXPECT_EQ(prevailing(std::array{elastic, elastic, shear, shear}), shear);
  EXPECT_EQ(prevailing(std::array{shear, elastic, shear, elastic}), shear);
  EXPECT_EQ(prevailing(std::array{shear, compaction}), compaction);
  EXPECT_EQ(prevailing(std::array{tension, compaction, shear, elastic}), tension);
  EXPECT_EQ(prevailing(std::array{elastic, elastic, elastic, tension, tension, tension, shear, shear}),
            tension);
}
