// The law `pressed` against the curve that it was made from, pressed here: a metal and the base case.

#include "fit/pressed.hpp"
#include "material/card.hpp"
#include "press/press.hpp"

#include <gtest/gtest.h>

namespace platen {
namespace {

TEST(Pressed, IsTheCurveThatItWasMadeFrom) {
  for (const char* name : {"von-mises-100", "base-case"}) {
    press::Simple e;
    e.unload_from = {0.1, 0.2, 0.3, 0.4, 0.5};
    const auto result = press::press({material::read_card(name).material, 1e-3, e});
    ASSERT_FALSE(result.failure);
    const auto fit = fit::fit_pressed(result.curve, fit::fit_unloading(result.curve));
    EXPECT_LE(fit.material.delta_bar.size(), 64u);
    EXPECT_LE(fit.errors.relative_l2, 0.003) << name;
    EXPECT_LE(fit.errors.worst, 0.01) << name;
    EXPECT_LE(fit.errors.radius, 0.01) << name;
    EXPECT_LE(fit.errors.unload_work, 0.02) << name;
  }
}

} // namespace
} // namespace platen
