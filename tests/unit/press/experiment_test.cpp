#include "press/press.hpp"

#include <gtest/gtest.h>

using namespace platen;

TEST(Experiment, GivesWhatTheExperimentKnows) {
  press::Case c;
  c.material = {"e", material::Elastic{1e9, 0.3}, {}};
  c.delta_bar_max = 0.001;
  c.elements = 200;
  EXPECT_TRUE(std::holds_alternative<press::Result>(press::press(c)));
  c.experiment = "local";
  EXPECT_TRUE(std::holds_alternative<press::Result>(press::press(c)));
  c.experiment = "die";
  const auto any = press::press(c);
  EXPECT_TRUE(std::holds_alternative<press::Result>(any));
  EXPECT_EQ(press::common(any).curve.experiment, "die");
}
