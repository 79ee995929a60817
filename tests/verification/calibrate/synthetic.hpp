#pragma once
// Measurements of a law with known parameters: gap, noise, zero of the load cell, compliance, loops,
// breakage.

#include "core/number.hpp"
#include "fit/law_card.hpp"
#include "measure/specimen.hpp"

#include <cmath>
#include <random>

namespace platen::synthetic {

struct Truth {
  std::string law;
  platen::law::ParameterTexts parameters;
  double compliance_m_per_N = 0, noise = 0; ///< noise: standard deviation over the largest force
};

struct Made {
  measure::Specimen specimen;
  double contact_m = 0; ///< travel
};

/// One particle to `delta_bar`: approach over `gap_m`, loading with two loops, unloading. `law`: against a
/// plane, for this particle. `breaks`: at this share of the way the force falls.
template <class Law>
Made measured_of(const Law& law, const Truth& truth, double diameter_m, double gap_m, double delta_bar,
                 double zero_N, std::mt19937_64& random, double breaks = 0) {
  const double R = diameter_m / 2, delta_max = delta_bar * R;
  std::vector<double> path;
  const double step = delta_max / 150;
  const auto go = [&](double to) {
    while (std::abs(to - path.back()) > 1.5 * step)
      path.push_back(path.back() + (to > path.back() ? step : -step));
    path.push_back(to);
  };
  path.push_back(-gap_m / 2);
  go(0.4 * delta_max);
  go(0.37 * delta_max);
  go(0.7 * delta_max);
  go(0.66 * delta_max);
  go(delta_max);
  const double fine = step / 3;
  for (double delta = delta_max - fine; delta > 0.85 * delta_max; delta -= fine) path.push_back(delta);

  Made made;
  auto& s = made.specimen;
  s.file = "synthetic";
  s.diameter_m = diameter_m;
  s.travel_unit = {"um", measure::Quantity::displacement, 1e-6};
  s.force_unit = {"N", measure::Quantity::force, 1};
  made.contact_m = gap_m;
  law::State state;
  double largest = 0, after = 1;
  std::vector<double> clean;
  for (double delta : path) {
    const auto response = evaluate(law, state, delta);
    state = response.state;
    if (breaks > 0 && delta > breaks * delta_max) after = 0.3;
    clean.push_back(after * response.force);
    largest = std::max(largest, clean.back());
  }
  std::normal_distribution<double> noise(0, truth.noise * largest);
  for (std::size_t i = 0; i < path.size(); ++i) {
    s.travel_m.push_back(2 * path[i] + gap_m + truth.compliance_m_per_N * clean[i]);
    s.force_N.push_back(clean[i] + zero_N + (truth.noise > 0 ? noise(random) : 0));
    s.time_s.push_back(0.1 * static_cast<double>(i));
    s.line.push_back(static_cast<int>(i) + 2);
  }
  return made;
}

/// Of a law by name.
inline Made measured(const Truth& truth, double diameter_m, double gap_m, double delta_bar, double zero_N,
                     std::mt19937_64& random, double breaks = 0) {
  fit::LawCard card;
  card.law = truth.law;
  card.parameters = truth.parameters;
  const auto law =
      fit::make_law(card, {{"radius_m", core::number_text(diameter_m / 2)}, {"against", "plane"}});
  return measured_of(law, truth, diameter_m, gap_m, delta_bar, zero_N, random, breaks);
}

} // namespace platen::synthetic
