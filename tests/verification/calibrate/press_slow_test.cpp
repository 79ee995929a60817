// Materials that no pool has, found through a few presses.

#include "calibrate/calibration.hpp"
#include "measure/as_measured.hpp"
#include "press/press.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

namespace {

using namespace platen;

struct Found {
  calibrate::Calibration calibration;
  int presses = 0;
};

Found through_presses(const calibrate::FreeMaterial& sought, const law::ParameterTexts& truth, int particles,
                      double noise) {
  press::Simple simple;
  simple.delta_bar_max = 0.3;
  simple.unload_from = {0.1, 0.2, 0.3};
  const auto curve = press::press({sought.with(truth), 0.5e-3, simple}).curve;
  measure::Measurement m{"synthetic", "", "", {}, {}};
  m.specimens = measure::batch(curve, particles, 1e-3, {20e-6, noise, 0, 0, 0.1}, 9);
  calibrate::Settings settings;
  settings.material = std::make_shared<calibrate::FreeMaterial>(sought);
  const auto folder =
      std::filesystem::temp_directory_path() / ("platen-through-presses-" + std::to_string(::getpid()));
  study::Store store(folder, "calibration");
  store.open_for_writing(study::OldRuns::recompute);
  Found found;
  found.calibration = calibrate::calibrate_material_by_presses(
      {m}, settings, {store, 2, [&](const std::string&) { ++found.presses; }});
  std::filesystem::remove_all(folder);
  return found;
}

void expect_back(const Found& found, const law::ParameterTexts& truth, double within) {
  const auto& c = found.calibration;
  for (std::size_t k = 0; k < c.free.size(); ++k) {
    const double expected = std::stod(truth.at(c.free[k].key));
    EXPECT_NEAR(c.values[k], expected, within * expected) << c.free[k].key;
    EXPECT_NEAR(c.values[k], expected, 4 * c.errors[k]) << c.free[k].key;
  }
  EXPECT_TRUE(c.doubts.empty());
  EXPECT_EQ(c.card.law, "pressed");
}

/// From the card of lead, half as strong.
TEST(ThroughPresses, OfAMetalThatHardens) {
  const law::ParameterTexts truth{
      {"E_Pa", "8e9"}, {"hardening.kappa_Pa", "40e6"}, {"hardening.inverse_m", "0.35"}};
  const auto found = through_presses(calibrate::FreeMaterial("lead-hollomon", {}, {}), truth, 5, 0.01);
  expect_back(found, truth, 0.05);
  EXPECT_LE(found.presses, 9);
}

/// A powder that the surrogate knows to a few per cent only.
TEST(ThroughPresses, OfAPowder) {
  const law::ParameterTexts truth{{"sigma_y_Pa", "8.61e6"}, {"E_Pa", "4.417e8"}};
  const auto found = through_presses(calibrate::FreeMaterial("mcc-ph-200", {}, {}), truth, 20, 0.02);
  expect_back(found, truth, 0.03);
  EXPECT_LE(found.presses, 7);
}

} // namespace
