#include "calibrate/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace platen::calibrate {
namespace {

std::string text_value(double value, double error) {
  return std::isfinite(error) ? fmt::format("{:.5g} +- {:.2g}", value, error) : fmt::format("{:.5g}", value);
}

/// How much of the error is noise, where the law itself is known only so well.
std::string noise_words(const Calibration& c, std::size_t k) {
  const double noise = c.noise_errors[k], all = c.errors[k];
  if (!c.material || !std::isfinite(all)) return "";
  return fmt::format(" (noise {:.2g}, curve of the material {:.2g})", noise,
                     std::sqrt(std::max(0.0, all * all - noise * noise)));
}

} // namespace

std::string zero_words(const Particle& p) {
  return fmt::format("{:.3g} N{}", p.baseline_N,
                     p.drift_fitted ? fmt::format(", drifting by {:.2g} N", p.drift_N) : "");
}

std::string words_of(const Calibration& c) {
  std::string text =
      fmt::format("{}, fitted to {} {} of {}, {} rows, up to delta/R = {:.3g}\n",
                  c.material ? fmt::format("material {}", material::model_name(c.material->model))
                             : fmt::format("law {}", c.card.law),
                  c.particles.size(), c.particles.size() == 1 ? "particle" : "particles",
                  c.particles.size() + c.broken.size(), c.rows, c.delta_bar_max);
  std::size_t widest = 12;
  for (const auto& free : c.free) widest = std::max(widest, free.key.size());
  for (std::size_t k = 0; k < c.free.size(); ++k)
    text += fmt::format(
        "  {:<{}} {}{}{}\n", c.free[k].key, widest, text_value(c.values[k], c.errors[k]), noise_words(c, k),
        c.profiles[k] ? fmt::format("; 95 % of the profile likelihood: {}", words_of(*c.profiles[k])) : "");
  for (std::size_t i = 0; i < c.free.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      text += fmt::format("  correlation of {} and {}: {:.3f}\n", c.free[j].key, c.free[i].key,
                          c.correlations[i][j]);
  text += fmt::format("  R2 = {:.6f}, relative L2 {:.2f} %\n", c.R2, 100 * c.relative_l2);
  text += "particles\n";
  for (const auto& p : c.particles) {
    text += fmt::format("  {}: d = {:.4g} mm, {} rows ({}), contact at {}, R2 = {:.6f}", p.name,
                        p.diameter_m * 1e3, p.rows, p.stages.words(), p.contact, p.R2);
    if (p.baseline_fitted) text += ", load cell zero " + zero_words(p);
    if (c.particles.size() > 1)
      for (std::size_t k = 0; k < p.values.size(); ++k)
        text += fmt::format(", {} = {:.4g}", c.free[k].key, p.values[k]);
    text += "\n";
  }
  for (const auto& sentence : c.broken) text += fmt::format("  {}\n", sentence);
  for (const auto& [key, value] : c.card.provenance)
    if (key == "machine") text += fmt::format("machine: {}\n", std::get<std::string>(value));
  for (const auto& sentence : c.said) text += sentence + "\n";
  return text;
}

} // namespace platen::calibrate
