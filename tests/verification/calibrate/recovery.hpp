#pragma once
// Known parameters sought in noisy measurements of twenty particles, again and again.

#include "calibrate/calibration.hpp"
#include "synthetic.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace platen::synthetic {

constexpr int particles = 20;

struct Tally {
  std::map<std::string, double> worst;        ///< relative deviation of the pooled value
  std::map<std::string, int> covered;         ///< truth within 1.96 standard errors
  double worst_contact = 0, mean_contact = 0; ///< over R
  int repetitions = 0;
};

inline Tally repeat(const Truth& truth, int repetitions, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> diameter(0.6e-3, 1.4e-3), gap(10e-6, 60e-6), zero(-1, 1);
  Tally tally;
  for (int r = 0; r < repetitions; ++r) {
    measure::Measurement m{"synthetic", "", "", {}, {}};
    std::vector<double> contacts;
    for (int p = 0; p < particles; ++p) {
      auto made = measured(truth, diameter(random), gap(random), 0.2, 0.005 * zero(random), random);
      made.specimen.name = std::to_string(p);
      contacts.push_back(made.contact_m);
      m.specimens.push_back(std::move(made.specimen));
    }
    calibrate::Settings settings;
    settings.law = truth.law;
    settings.given = {{"nu", truth.parameters.at("nu")}};
    settings.machine = {truth.compliance_m_per_N, {}, {}, "given"};
    const auto c = calibrate::calibrate({m}, settings);
    EXPECT_EQ(c.particles.size(), static_cast<std::size_t>(particles)) << "no whole particle is refused";
    for (std::size_t k = 0; k < c.free.size(); ++k) {
      const double expected = std::stod(truth.parameters.at(c.free[k].key));
      auto& worst = tally.worst[c.free[k].key];
      worst = std::max(worst, std::abs(c.values[k] / expected - 1));
      tally.covered[c.free[k].key] += std::abs(c.values[k] - expected) < 1.96 * c.errors[k];
    }
    for (const auto& p : c.particles) {
      const double off =
          std::abs(p.contact_m - contacts[static_cast<std::size_t>(std::stoi(p.name))]) / (p.diameter_m / 2);
      tally.worst_contact = std::max(tally.worst_contact, off);
      tally.mean_contact += off / particles / repetitions;
    }
    ++tally.repetitions;
  }
  for (const auto& [key, worst] : tally.worst)
    testing::Test::RecordProperty(
        key, fmt::format("worst {:.2e}, covered {} of {}", worst, tally.covered[key], repetitions));
  return tally;
}

inline const Truth granule{
    "shahin",
    {{"kappa_Pa", "6.0272e6"}, {"inverse_m", "0.6585"}, {"E_Pa", "0.4e9"}, {"nu", "0.3"}},
    1e-6,
    0.02};
inline const Truth metal{"agarwal", {{"sigma_y_Pa", "12e6"}, {"E_Pa", "2e9"}, {"nu", "0.3"}}, 0.4e-6, 0.02};

} // namespace platen::synthetic
