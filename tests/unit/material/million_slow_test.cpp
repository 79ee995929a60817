// A million random finite increments for each model.

#include "random_increments.hpp"

TEST(MillionIncrements, AreAnsweredRightByEveryModel) {
  platen::material::testing::check_every_model(1000000, 50);
}
