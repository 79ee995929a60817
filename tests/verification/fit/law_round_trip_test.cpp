// The law as a DEM code runs it, pressed and unloaded like a particle, then fitted: out come the parameters
// that went in. This ties the fit to the law header: both must read (6) and (9)-(14) alike.

#include "fit/edmans_sinka.hpp"
#include "fit/unloading.hpp"
#include "platen/law/edmans_sinka.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace platen {
namespace {

/// About MCC PH-200 (the example of docs/reference/law-card.md) with unloading parameters of the size of ES
/// Figs 15a, 15b.
law::EdmansSinkaMaterial material() {
  law::EdmansSinkaMaterial m;
  m.sigma_ref = 8.61e6;
  m.E = 4.417e8;
  m.nu = 0.1472;
  m.k = 4.2;
  m.delta_t = 0.09;
  m.a = 3.5;
  m.unloadings = 3;
  for (int i = 0; i < 3; ++i) {
    m.unload_delta_bar[i] = 0.1 + 0.2 * i;
    m.alpha[i] = 1.4 - 0.1 * i;
    m.beta[i] = 1.3 + 0.2 * i;
  }
  return m;
}

/// Loads to 0.5 and unloads from each overlap of the card, against a rigid plane: there gamma is delta.
press::Curve pressed(const law::EdmansSinkaMaterial& m) {
  press::Curve curve;
  curve.radius_m = 2e-4;
  curve.sigma_ref_Pa = m.sigma_ref;
  curve.E_Pa = m.E;
  curve.nu = m.nu;
  auto law = law::prepare_on_rigid_plane(m, curve.radius_m);
  const auto add = [&](const law::Response& now, double delta_bar, press::Branch branch, int id) {
    press::CurvePoint point;
    point.branch = branch;
    point.branch_id = id;
    point.delta_bar = delta_bar;
    point.F_bar = now.force / (std::numbers::pi * curve.radius_m * curve.radius_m * m.sigma_ref);
    curve.points.push_back(point);
  };
  law::State loaded;
  int next = 0;
  std::vector<std::pair<double, law::State>> turning_points;
  for (int i = 0; i <= 250; ++i) {
    const double delta_bar = 0.002 * i;
    const law::Response now = law::evaluate(law, loaded, delta_bar * curve.radius_m);
    loaded = now.state;
    add(now, delta_bar, press::Branch::loading, 0);
    if (next < 3 && std::abs(delta_bar - m.unload_delta_bar[next]) < 1e-9) {
      turning_points.emplace_back(delta_bar, loaded);
      ++next;
    }
  }
  for (std::size_t branch = 0; branch < turning_points.size(); ++branch) {
    auto [turning, state] = turning_points[branch];
    for (double delta_bar = turning;; delta_bar -= 0.0005) {
      const law::Response now = law::evaluate(law, state, delta_bar * curve.radius_m);
      state = now.state;
      add(now, delta_bar, press::Branch::unloading, static_cast<int>(branch) + 1);
      if (now.force <= 0) break;
    }
  }
  return curve;
}

TEST(LawRoundTrip, TheFitReturnsTheParametersOfTheLaw) {
  const auto m = material();
  const auto curve = pressed(m);
  const auto loading = fit::fit_edmans_sinka(curve);
  EXPECT_NEAR(loading.k, m.k, 1e-6);
  EXPECT_NEAR(loading.delta_t, m.delta_t, 1e-7);
  EXPECT_NEAR(loading.a, m.a, 1e-6);
  const auto unloading = fit::fit_unloading(curve);
  ASSERT_EQ(unloading.fits.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(unloading.fits[i].delta_bar_max, m.unload_delta_bar[i], 1e-9);
    EXPECT_NEAR(unloading.fits[i].alpha, m.alpha[i], 1e-5) << i;
    EXPECT_NEAR(unloading.fits[i].beta, m.beta[i], 1e-5) << i;
    EXPECT_GT(unloading.fits[i].r_squared, 1 - 1e-9);
  }
}

} // namespace
} // namespace platen
