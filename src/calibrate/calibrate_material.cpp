#include "calibrate/calibration.hpp"
#include "calibrate/press_curves.hpp"
#include "core/error.hpp"
#include "core/number.hpp"
#include "core/version.hpp"
#include "fit/pressed.hpp"
#include "press/curve_csv.hpp"
#include "surrogate/predicted_law.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <utility>

namespace platen::calibrate {
namespace {

using core::InvalidInput;

/// Six digits, as in the law card.
material::Material found(const Calibration& c, const FreeMaterial& sought) {
  law::ParameterTexts texts;
  for (std::size_t k = 0; k < c.free.size(); ++k)
    texts[c.free[k].key] = core::number_text(*core::number_from(fmt::format("{:.6g}", c.values[k])));
  auto material = sought.with(texts);
  if (!material.name.starts_with("calibrated")) material.name = "calibrated from " + material.name;
  return material;
}

/// The law that was predicted for the material, with what is known of the fit.
fit::LawCard with_fit(fit::LawCard card, const fit::LawCard& fitted) {
  for (auto [key, value] : fitted.errors) {
    if (key == "relative_l2") key = "measured_relative_l2";
    card.errors.emplace_back(std::move(key), std::move(value));
  }
  for (const auto& one : fitted.provenance)
    if (std::holds_alternative<std::monostate>(fit::value_of(card.provenance, one.first)))
      card.provenance.push_back(one);
  return card;
}

/// What a card calls a parameter that was looked for as a ratio or inside a section.
std::string card_key(const std::string& key) {
  if (const auto dot = key.find('.'); dot != key.npos) return key.substr(0, dot);
  return key.ends_with("_bar") ? key.substr(0, key.size() - 4) + "_Pa" : key;
}

void say_held(Calibration& c, const FreeMaterial& sought) {
  if (std::holds_alternative<material::Vmdc>(c.material->model) ||
      std::holds_alternative<material::Dpc>(c.material->model))
    c.said.push_back(fmt::format("held as it was given: {}; a force curve alone does not identify a porous "
                                 "material (Edmans & Sinka, section 7)",
                                 sought.held()));
}

Calibration by_surrogate(const std::vector<measure::Measurement>& measurements, Settings settings) {
  const auto& sought = *settings.material;
  try {
    settings.curves = surrogate_curves(sought.typical());
  } catch (const InvalidInput& error) {
    throw InvalidInput(fmt::format("{}; --press calibrates through presses, --law NAME a law", error.what()));
  }
  Calibration c = calibrate(measurements, settings);
  c.material = found(c, sought);
  const auto answer = surrogate_answer(sought.typical(), *c.material);
  c.card = with_fit(pressed_card(answer, *c.material), c.card);
  const auto verdict = answer.assessment.verdict;
  const auto& reasons = answer.assessment.reasons;
  if (verdict != surrogate::Verdict::inside)
    c.doubts.push_back({verdict == surrogate::Verdict::outside,
                        fmt::format("the material found is {} of what was pressed (pool {}): {}; --press "
                                    "presses it",
                                    verdict == surrogate::Verdict::outside ? "outside" : "near the edge",
                                    answer.surrogate.pool, fmt::join(reasons, "; "))});
  return c;
}

/// How far the particles were pressed, and the stress F/(pi R delta) there of the first of them.
struct Reach {
  double delta_bar = 0, stress_Pa = 0;
};
Reach reach_of(const std::vector<measure::Measurement>& measurements, const Settings& settings) {
  Reach reach;
  for (const auto& m : measurements)
    for (const auto& specimen : m.specimens) {
      if (!specimen.diameter_m) continue; // refused where all is read
      const auto stages = measure::stages_of(specimen);
      if (stages.broke) continue;
      const auto s = samples_of(specimen, stages, settings.machine, true);
      for (std::size_t i = 0; i < s.force_N.size(); ++i) {
        const double delta = s.delta(i, s.contact_guess_m);
        reach.delta_bar = std::max(reach.delta_bar, delta / s.radius_m);
        if (&specimen == &measurements.front().specimens.front() && s.force_N[i] == s.force_max_N &&
            delta > 0)
          reach.stress_Pa = s.force_max_N / (std::numbers::pi * s.radius_m * delta);
      }
    }
  return reach;
}

/// Where to begin: at a surrogate's answer, or at the card.
std::vector<double> beginning(const std::vector<measure::Measurement>& measurements,
                              const Settings& settings) {
  try {
    return by_surrogate(measurements, settings).values;
  } catch (const InvalidInput& error) {
    if (!settings.material->of_card().empty()) return settings.material->of_card();
    throw InvalidInput(fmt::format("{}; to begin presses, give a card of a similar material: --material CARD",
                                   error.what()));
  }
}

Calibration by_presses(const std::vector<measure::Measurement>& measurements, Settings settings,
                       const Presses& means) {
  const auto& sought = *settings.material;
  const Reach reach = reach_of(measurements, settings);
  const auto asked = std::exchange(settings.asked, {}); // for the last of the searches
  const bool all_profiles = std::exchange(settings.all_profiles, false);
  constexpr double room = 1.05, most = 0.5;
  settings.start = beginning(measurements, settings);
  PressCurves presses(sought, settings.start,
                      {.store = means.store,
                       .workers = means.workers,
                       .delta_bar_max = std::min(most, room * reach.delta_bar),
                       .say = means.say});
  settings.curves = presses.curves();
  const auto& end = *press::loading_end(presses.last());
  const double stress = end.F_bar * presses.last().sigma_ref_Pa / end.delta_bar;
  for (std::size_t k = 0; k < settings.start.size(); ++k) // a card may be of another strength altogether
    if (sought.free()[k].in_curve_stress && reach.stress_Pa > 0)
      settings.start[k] *= reach.stress_Pa / stress;
  constexpr int most_steps = 6;
  constexpr double settled = 3e-3; // of the force
  double off = 1;
  for (int i = 0; i < most_steps && off > settled; ++i) {
    settings.start = calibrate(measurements, settings).values;
    off = presses.press(settings.start);
  }
  settings.asked = asked, settings.all_profiles = all_profiles;
  Calibration c = calibrate(measurements, settings);
  c.material = found(c, sought);
  auto curve = presses.last();
  curve.material = c.material->name;
  c.card = with_fit(law_card(curve, fit_pressed(curve, fit::fit_unloading(curve)), press::curve_csv(curve)),
                    c.card);
  c.said.push_back(fmt::format("{} presses; the last differed by {:.2g} % from what was expected of it",
                               presses.presses(), 100 * off));
  if (off > settled)
    c.doubts.push_back({false, fmt::format("the presses have not settled: the last was {:.2g} % off what was "
                                           "expected of it",
                                           100 * off)});
  return c;
}

} // namespace

Calibration calibrate_material(const std::vector<measure::Measurement>& measurements,
                               const Settings& settings) {
  auto c = by_surrogate(measurements, settings);
  say_held(c, *settings.material);
  return c;
}

Calibration calibrate_material_by_presses(const std::vector<measure::Measurement>& measurements,
                                          const Settings& settings, const Presses& means) {
  auto c = by_presses(measurements, settings, means);
  say_held(c, *settings.material);
  return c;
}

std::string material_card(const Calibration& c, const std::vector<std::string>& doubts) {
  std::string text = card_text(*c.material) + "\n[source]\n";
  std::vector<std::string> files;
  for (const auto& [key, value] : c.card.provenance)
    if (key.starts_with("source") && !key.starts_with("source_sha"))
      files.push_back(std::get<std::string>(value));
  std::string all =
      fmt::format("calibrated by platen (engine {}) from {} of {}, up to delta/R = {:.3g}", core::engine,
                  c.particles.size() == 1 ? "one particle" : fmt::format("{} particles", c.particles.size()),
                  fmt::join(files, ", "), c.delta_bar_max);
  if (!c.said.empty()) all += fmt::format("; {}", fmt::join(c.said, "; "));
  if (!doubts.empty()) all += fmt::format("; doubted: {}", fmt::join(doubts, "; "));
  text += fmt::format("default = {}\n", core::in_quotes(all));
  std::map<std::string, std::string> sources; // by the card's own keys: several may be of one section
  for (std::size_t k = 0; k < c.free.size(); ++k) {
    std::string words = fmt::format("{:.5g} +- {:.2g} (standard error, of which noise {:.2g})", c.values[k],
                                    c.errors[k], c.noise_errors[k]);
    if (c.profiles[k]) words += "; 95 % of the profile likelihood: " + words_of(*c.profiles[k]);
    const auto& sought = c.free[k].key;
    const auto key = card_key(sought);
    auto& source = sources[key];
    source += fmt::format("{}{}{}", source.empty() ? "" : "; ", key == sought ? "" : sought + " = ", words);
  }
  for (const auto& [key, words] : sources) text += fmt::format("{} = {}\n", key, core::in_quotes(words));
  return text;
}

} // namespace platen::calibrate
