#pragma once
// Known materials sought in noisy measurements of twenty particles. The truth of each repetition is not what
// the surrogate says of the material, but that and what it may be off by, drawn by chance: so the intervals
// must hold both.

#include "calibrate/calibration.hpp"
#include "core/number.hpp"
#include "recovery.hpp"

#include <cmath>

namespace platen::synthetic {

/// A curve of the material as it may be, if the surrogate knows how well it knows it.
inline law::PressedMaterial drawn(const calibrate::Curves& curves, const material::Material& m,
                                  std::mt19937_64& random) {
  auto truth = curves.of(m);
  const auto best = truth;
  std::normal_distribution<double> normal(0, 1);
  for (const auto& way : curves.astray(m)) {
    const double z = normal(random);
    const auto shift = [&](std::vector<double>& values, const std::vector<double>& of_way,
                           const std::vector<double>& of_best) {
      for (std::size_t i = 0; i < values.size(); ++i) values[i] *= std::pow(of_way[i] / of_best[i], z);
    };
    shift(truth.F_bar, way.F_bar, best.F_bar);
    shift(truth.alpha, way.alpha, best.alpha);
    shift(truth.beta, way.beta, best.beta);
  }
  for (std::size_t i = 1; i < truth.F_bar.size(); ++i)
    truth.F_bar[i] = std::max(truth.F_bar[i], truth.F_bar[i - 1] * (1 + 2e-5));
  for (double& alpha : truth.alpha) alpha = std::max(alpha, 1.0);
  return truth;
}

inline Tally repeat_material(const calibrate::FreeMaterial& sought, const law::ParameterTexts& values,
                             int repetitions, std::uint64_t seed) {
  const auto material = sought.with(values);
  const auto curves = calibrate::surrogate_curves(material);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> diameter(0.6e-3, 1.4e-3), gap(10e-6, 60e-6), zero(-1, 1);
  const Truth instrument{"", {}, 0.4e-6, 0.02};
  Tally tally;
  for (int r = 0; r < repetitions; ++r) {
    measure::Measurement m{"synthetic", "", "", {}, {}};
    const auto truth = drawn(curves, material, random);
    for (int p = 0; p < particles; ++p) {
      const double d = diameter(random);
      const auto law = law::prepare_on_rigid_plane(truth, d / 2);
      auto made = measured_of(law, instrument, d, gap(random), 0.2, 0.005 * zero(random), random);
      made.specimen.name = std::to_string(p);
      m.specimens.push_back(std::move(made.specimen));
    }
    calibrate::Settings settings;
    settings.machine = {instrument.compliance_m_per_N, {}, {}, "given"};
    settings.material = std::make_shared<calibrate::FreeMaterial>(sought);
    const auto c = calibrate::calibrate_material({m}, settings);
    EXPECT_EQ(c.particles.size(), static_cast<std::size_t>(particles));
    for (std::size_t k = 0; k < c.free.size(); ++k) {
      const double expected = std::stod(values.at(c.free[k].key));
      auto& worst = tally.worst[c.free[k].key];
      worst = std::max(worst, std::abs(c.values[k] / expected - 1));
      tally.covered[c.free[k].key] += std::abs(c.values[k] - expected) < 1.96 * c.errors[k];
    }
    ++tally.repetitions;
  }
  for (const auto& [key, worst] : tally.worst)
    testing::Test::RecordProperty(
        key, fmt::format("worst {:.2e}, covered {} of {}", worst, tally.covered[key], repetitions));
  return tally;
}

inline const law::ParameterTexts bead{{"sigma_y_Pa", "25e6"}, {"E_Pa", "2e9"}};

} // namespace platen::synthetic
