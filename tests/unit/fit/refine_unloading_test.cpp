#include "fit/refine_unloading.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace platen::fit {
namespace {

/// `platen derive NAME --unload_from 0.05,0.1,0.15,0.2,0.25,0.3,0.4,0.5`, engine 6: alpha and beta of the law
/// pressed.
struct Pressed {
  const char* name;
  std::vector<double> alpha, beta;
};
const std::vector<double> all = {0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5};
const std::vector<Pressed> materials = {
    {"von-mises-100",
     {1.3159, 1.3283, 1.2651, 1.2033, 1.1698, 1.1358, 1.0951, 1.0570},
     {2.6660, 3.5133, 4.4180, 5.4291, 6.4669, 7.6061, 10.6725, 15.5746}},
    {"base-case",
     {1.3413, 1.3927, 1.7043, 1.7100, 1.4876, 1.2832, 1.1415, 1.1633},
     {2.8599, 3.3754, 3.5208, 4.0813, 5.2883, 6.8881, 10.8307, 16.5209}},
    {"mcc-ph-200",
     {1.3070, 1.3080, 1.3226, 1.2747, 1.2145, 1.2091, 1.2264, 1.1493},
     {2.1463, 2.7589, 3.3017, 3.9725, 4.7720, 5.5037, 7.6260, 11.5806}},
    {"lactose-dt",
     {1.2879, 1.2915, 1.2018, 1.1728, 1.1498, 1.1548, 1.1217, 1.0733},
     {4.6823, 5.9384, 7.5626, 8.9562, 10.5151, 12.0970, 16.9065, 25.0227}}};

double at(const std::vector<double>& x, const std::vector<double>& y, double where) {
  const auto found = std::ranges::find_if(x, [&](double one) { return std::abs(one - where) < 1e-9; });
  EXPECT_NE(found, x.end());
  return y[static_cast<std::size_t>(found - x.begin())];
}

// Unloading from five overlaps, against what those between and below were pressed to be.
TEST(RefineUnloading, SaysWhatLiesBetween) {
  for (const auto& pressed : materials) {
    law::PressedMaterial m;
    for (const double x : {0.1, 0.2, 0.3, 0.4, 0.5}) {
      m.unload_delta_bar.push_back(x);
      m.alpha.push_back(at(all, pressed.alpha, x));
      m.beta.push_back(at(all, pressed.beta, x));
    }
    refine_unloading(m);
    EXPECT_EQ(m.unload_delta_bar.size(), 19U);
    EXPECT_TRUE(std::ranges::is_sorted(m.unload_delta_bar));
    for (const auto& [x, work_off, slope_off] :
         {std::tuple{0.05, 0.045, 0.065}, {0.15, 0.013, 0.048}, {0.25, 0.008, 0.005}}) {
      const double alpha = at(m.unload_delta_bar, m.alpha, x), beta = at(m.unload_delta_bar, m.beta, x),
                   alpha_true = at(all, pressed.alpha, x), beta_true = at(all, pressed.beta, x);
      EXPECT_NEAR(beta_true * (1 + alpha_true) / (beta * (1 + alpha)), 1, work_off)
          << pressed.name << " " << x;
      EXPECT_NEAR(alpha * beta / (alpha_true * beta_true), 1, slope_off) << pressed.name << " " << x;
    }
    for (const double x : {0.1, 0.2, 0.3, 0.4, 0.5}) {
      EXPECT_EQ(at(m.unload_delta_bar, m.alpha, x), at(all, pressed.alpha, x));
      EXPECT_EQ(at(m.unload_delta_bar, m.beta, x), at(all, pressed.beta, x));
    }
  }
}

TEST(RefineUnloading, LeavesFewBranchesAsTheyAre) {
  law::PressedMaterial m;
  m.unload_delta_bar = {0.1, 0.3, 0.5}, m.alpha = {1.4, 1.3, 1.2}, m.beta = {2, 5, 9};
  const auto before = m;
  refine_unloading(m);
  EXPECT_EQ(m, before);
}

} // namespace
} // namespace platen::fit
