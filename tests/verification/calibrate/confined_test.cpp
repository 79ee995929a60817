// Bands of a prediction are what drawing parameters by their covariance gives.

#include "calibrate/confined.hpp"
#include "recovery.hpp"

namespace {

using namespace platen;

calibrate::Calibration granule() {
  std::mt19937_64 random(21);
  measure::Measurement m{"synthetic", "", "", {}, {}};
  m.specimens.push_back(synthetic::measured(synthetic::granule, 1e-3, 20e-6, 0.2, 0, random).specimen);
  calibrate::Settings s;
  s.law = "shahin";
  s.given = {{"nu", "0.3"}, {"E_Pa", "0.4e9"}};
  s.machine = {synthetic::granule.compliance_m_per_N, {}, {}, "given"};
  return calibrate::calibrate({m}, s);
}

const calibrate::ConfinedCurve& of(const std::vector<calibrate::ConfinedCurve>& curves, const char* loading) {
  return *std::ranges::find(curves, loading, &calibrate::ConfinedCurve::loading);
}

double pressure(const calibrate::Calibration& c, const std::string& loading, double kappa, double inverse_m,
                double x) {
  const auto law = fit::make_law(c.card, {{"radius_m", "1"},
                                          {"against", "plane"},
                                          {"loading", loading},
                                          {"kappa_Pa", core::number_text(kappa)},
                                          {"inverse_m", core::number_text(inverse_m)}});
  return evaluate(law, law::State{}, x).force / std::numbers::pi;
}

TEST(Confined, BandsAreThoseOfParametersDrawnByTheirCovariance) {
  const auto c = granule();
  ASSERT_EQ(c.free.size(), 2U);
  const auto die = of(calibrate::confined(c), "die");
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal(0, 1);
  const double r = c.correlations[0][1];
  for (const std::size_t i : {11U, 35U}) {
    std::vector<double> drawn;
    for (int n = 0; n < 400; ++n) {
      const double a = normal(random), b = r * a + std::sqrt(1 - r * r) * normal(random);
      drawn.push_back(pressure(c, "die", c.values[0] * std::exp(a * c.errors[0] / c.values[0]),
                               c.values[1] + b * c.errors[1], die.delta_bar[i]));
    }
    double mean = 0, square = 0;
    for (double p : drawn) mean += p / 400;
    for (double p : drawn) square += (p - mean) * (p - mean) / 399;
    const auto& band = die.pressure_Pa[i];
    EXPECT_NEAR(band.value, pressure(c, "die", c.values[0], c.values[1], die.delta_bar[i]),
                1e-4 * band.value);
    EXPECT_NEAR((band.high - band.low) / 2, 1.96 * std::sqrt(square), 0.15 * 1.96 * std::sqrt(square)) << i;
  }
}

/// The cells of Shahin, section 2.2: full at 1 - pi/6 in a die, at 1 - (pi/6)^(1/3) from all sides.
TEST(Confined, EndsWhereTheCellIsFull) {
  const auto curves = calibrate::confined(granule());
  EXPECT_NEAR(of(curves, "simple").delta_bar.back(), 0.5, 1e-9);
  EXPECT_NEAR(of(curves, "die").delta_bar.back(), 1 - std::numbers::pi / 6, 0.01);
  EXPECT_NEAR(of(curves, "hydrostatic").delta_bar.back(), 1 - std::cbrt(std::numbers::pi / 6), 0.01);
  // Confinement takes more force, Fig. 3.9, and more contact, Fig. 3.10.
  for (const std::size_t i : {11U, 20U}) {
    EXPECT_GT(of(curves, "die").pressure_Pa[i].value, of(curves, "simple").pressure_Pa[i].value);
    EXPECT_GT(of(curves, "hydrostatic").pressure_Pa[i].value, of(curves, "die").pressure_Pa[i].value);
    EXPECT_GT(of(curves, "hydrostatic").a_bar[i].value, of(curves, "die").a_bar[i].value);
  }
}

} // namespace
