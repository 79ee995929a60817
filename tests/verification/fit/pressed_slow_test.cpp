// The law `pressed` against the curve that it was made from, pressed here: a metal, the base case, and the
// corner of the pool `edmans-sinka` whose curve has the most ripple.

#include "fit/pressed.hpp"
#include "material/card.hpp"
#include "press/press.hpp"

#include <gtest/gtest.h>

namespace platen {
namespace {

TEST(Pressed, IsTheCurveThatItWasMadeFrom) {
  auto rippled = material::read_card("base-case").material;
  auto& vmdc = std::get<material::Vmdc>(rippled.model);
  vmdc.E = 500 * vmdc.sigma_y, vmdc.Gamma = 0.25 * vmdc.sigma_y, vmdc.Lambda = 0.01 * vmdc.sigma_y;
  rippled.name = "rippled";
  for (const auto& material :
       {material::read_card("von-mises-100").material, material::read_card("base-case").material, rippled}) {
    press::Simple e;
    e.unload_from = {0.1, 0.2, 0.3, 0.4, 0.5};
    const auto result = press::press({material, 1e-3, e});
    const auto& name = material.name;
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
