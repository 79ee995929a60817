// Twenty thousand of the increments of million_slow_test.cpp for each model.

#include "random_increments.hpp"

TEST(RandomIncrements, AreAnsweredRightByEveryModel) {
  platen::material::testing::check_every_model(20000, 20);
}
