#include "calibrate/confined.hpp"

#include "core/error.hpp"
#include "core/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace platen::calibrate {
namespace {

constexpr int points = 60;

/// F/(pi R^2) and a/R of a law against a plane, R = 1; NaN outside of its range.
struct Response {
  double pressure, a;
};
Response response(const law::Law& law, double delta_bar) {
  const auto r = evaluate(law, law::State{}, delta_bar);
  if (!r.in_range) return {std::nan(""), std::nan("")};
  return {r.force / std::numbers::pi, r.contact_radius};
}

law::Law law_of(const Calibration& c, const std::string& loading, std::size_t moved, double by) {
  law::ParameterTexts more{{"radius_m", "1"}, {"against", "plane"}, {"loading", loading}};
  if (moved < c.free.size()) {
    const double value = c.free[moved].logarithmic ? c.values[moved] * std::exp(by) : c.values[moved] + by;
    more[c.free[moved].key] = core::number_text(value);
  }
  return fit::make_law(c.card, more);
}

Banded banded(double value, const std::vector<double>& gradient, const Calibration& c) {
  double variance = 0;
  for (std::size_t i = 0; i < gradient.size(); ++i)
    for (std::size_t j = 0; j < gradient.size(); ++j)
      variance += gradient[i] * gradient[j] * c.correlations[i][j];
  const double half = 1.96 * std::sqrt(std::max(0.0, variance));
  return {value, std::max(0.0, value - half), value + half};
}

} // namespace

std::vector<ConfinedCurve> confined(const Calibration& c) {
  const auto& words = law::find_law(c.card.law).words;
  if (c.material || std::ranges::none_of(words, [](const auto& w) { return w.key == "loading"; }))
    throw core::InvalidInput(
        c.material
            ? fmt::format("--confined is for the laws agarwal and shahin; press the material in a die: "
                          "experiment = \"die\", `platen press --help`")
            : fmt::format("--confined: law {} knows one loading only; agarwal and shahin know the die and "
                          "pressure from all sides",
                          c.card.law));
  std::vector<ConfinedCurve> curves;
  for (const std::string loading : {"simple", "die", "hydrostatic"}) {
    const auto best = law_of(c, loading, c.free.size(), 0);
    // A step of a tenth of the standard error: the law is linear over so little.
    std::vector<law::Law> moved;
    std::vector<double> steps;
    for (std::size_t k = 0; k < c.free.size(); ++k) {
      const double scale = c.free[k].logarithmic ? std::abs(c.values[k]) : 1;
      const double error = std::isfinite(c.errors[k]) ? c.errors[k] / scale : 0;
      steps.push_back(std::clamp(0.1 * error, 1e-4, 0.05));
      moved.push_back(law_of(c, loading, k, -steps.back())); // below: 1/m may stand at its bound of 1
    }
    ConfinedCurve curve{loading, {}, {}, {}};
    for (int i = 1; i <= points; ++i) {
      const double x = 0.5 * i / points;
      const auto here = response(best, x);
      std::vector<double> of_pressure, of_a;
      for (std::size_t k = 0; k < c.free.size(); ++k) {
        const auto beside = response(moved[k], x);
        const double scale = c.free[k].logarithmic ? std::abs(c.values[k]) : 1;
        const double error = std::isfinite(c.errors[k]) ? c.errors[k] / scale : 0;
        of_pressure.push_back((here.pressure - beside.pressure) / steps[k] * error);
        of_a.push_back((here.a - beside.a) / steps[k] * error);
      }
      const auto pressure = banded(here.pressure, of_pressure, c), a = banded(here.a, of_a, c);
      if (!std::isfinite(pressure.high)) {
        if (curve.delta_bar.empty()) continue; // Hertz's force is less
        break;                                 // the cell is full
      }
      curve.delta_bar.push_back(x), curve.pressure_Pa.push_back(pressure), curve.a_bar.push_back(a);
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

std::string confined_csv(const std::vector<ConfinedCurve>& curves) {
  std::string text =
      "loading,delta_bar,F_over_pi_R2_Pa,F_over_pi_R2_low_Pa,F_over_pi_R2_high_Pa,a_bar,a_bar_low,"
      "a_bar_high\n";
  for (const auto& c : curves)
    for (std::size_t i = 0; i < c.delta_bar.size(); ++i)
      text += fmt::format("{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n", c.loading, c.delta_bar[i],
                          c.pressure_Pa[i].value, c.pressure_Pa[i].low, c.pressure_Pa[i].high,
                          c.a_bar[i].value, c.a_bar[i].low, c.a_bar[i].high);
  return text;
}

} // namespace platen::calibrate
