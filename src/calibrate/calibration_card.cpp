#include "calibrate/calibration.hpp"
#include "core/number.hpp"
#include "core/version.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace platen::calibrate {
namespace {

std::string machine_words(const std::vector<measure::Measurement>& measurements,
                          const measure::Machine& machine) {
  if (machine.given()) return machine.said;
  for (const auto& m : measurements)
    for (const auto& sentence : m.said)
      if (sentence.starts_with("machine taken off")) return sentence;
  return "no compliance of the machine taken off: where it gives way the particle seems softer";
}

} // namespace

fit::LawCard card_of(const Calibration& c, fit::LawCard card,
                     const std::vector<measure::Measurement>& measurements, const measure::Machine& machine) {
  const auto rounded = [](double v) {
    return core::number_text(*core::number_from(fmt::format("{:.6g}", v)));
  };
  for (std::size_t k = 0; k < c.free.size(); ++k) card.parameters[c.free[k].key] = rounded(c.values[k]);
  card.delta_bar = {0.0, c.delta_bar_max};
  const auto number = [](double v) { return *core::number_from(fmt::format("{:.4g}", v)); };
  card.errors.emplace_back("relative_l2", number(c.relative_l2));
  card.errors.emplace_back("R2", *core::number_from(fmt::format("{:.6g}", c.R2)));
  const auto bare = [&](std::size_t k) { // "hardening.kappa_Pa" would be a key in a section
    const auto& key = c.free[k].key;
    return key.substr(key.find('.') + 1);
  };
  for (std::size_t k = 0; k < c.free.size(); ++k)
    if (std::isfinite(c.errors[k]))
      card.errors.emplace_back("standard_error_" + bare(k), number(c.errors[k]));
  for (std::size_t k = 0; k < c.free.size(); ++k)
    if (const auto& p = c.profiles[k]; p && !p->open_low && !p->open_high)
      card.errors.emplace_back("profile_95_" + bare(k), std::vector<double>{number(p->low), number(p->high)});
  for (std::size_t i = 0; i < c.free.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      card.errors.emplace_back(fmt::format("correlation_{}_{}", bare(j), bare(i)),
                               number(c.correlations[i][j]));
  auto& from = card.provenance;
  int n = 0;
  for (const auto& m : measurements) {
    const std::string tail = measurements.size() > 1 ? fmt::format("_{}", ++n) : "";
    from.emplace_back("source" + tail, m.file);
    from.emplace_back("source_sha256" + tail, m.sha256);
    std::string found = m.read_as;
    for (const auto& sentence : m.said) found += "; " + sentence;
    from.emplace_back("found" + tail, found);
  }
  from.emplace_back("particles", static_cast<int>(c.particles.size()));
  from.emplace_back("rows", static_cast<int>(c.rows));
  if (!c.broken.empty()) from.emplace_back("broken", fmt::format("{}", fmt::join(c.broken, "; ")));
  std::vector<std::string> contacts, baselines;
  for (const auto& p : c.particles) {
    const std::string name = c.particles.size() > 1 ? p.name + ": " : "";
    contacts.push_back(name + p.contact);
    if (p.baseline_fitted) baselines.push_back(name + zero_words(p));
  }
  from.emplace_back("contact_fitted", fmt::format("{}", fmt::join(contacts, ", ")));
  from.emplace_back("baseline_fitted", baselines.empty() ? std::string("none: no row out of contact")
                                                         : fmt::format("{}", fmt::join(baselines, ", ")));
  from.emplace_back("machine", machine_words(measurements, machine));
  if (!c.said.empty()) from.emplace_back("remarks", fmt::format("{}", fmt::join(c.said, "; ")));
  from.emplace_back("engine", core::engine);
  return card;
}

} // namespace platen::calibrate
