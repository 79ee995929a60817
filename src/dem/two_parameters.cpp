#include "dem/two_parameters.hpp"

#include "core/error.hpp"
#include "core/number.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

namespace platen::dem {
namespace {

constexpr int steps = 2000;

/// The factor of `shape` that is nearest to `force` in L2 (trapezoid weights), and what it misses, relative.
std::array<double, 2> nearest(const std::vector<double>& force, const std::vector<double>& shape) {
  double both = 0, own = 0, all = 0;
  for (std::size_t i = 0; i < force.size(); ++i) {
    const double weight = i == 0 || i + 1 == force.size() ? 0.5 : 1;
    both += weight * force[i] * shape[i];
    own += weight * shape[i] * shape[i];
    all += weight * force[i] * force[i];
  }
  const double factor = both / own, missed = all - factor * both;
  return {factor, missed > 0 ? std::sqrt(missed / all) : 0};
}

double restitution_of(const law::Law& law, double gamma) {
  const double spent = law::loading_work(law, gamma);
  if (!(spent > 0)) return 1;
  const double back = 1 - law::evaluate(law, {}, gamma).dissipated_work / spent;
  return back > 0 ? std::sqrt(back) : 0;
}

} // namespace

TwoParameters two_parameters(const fit::LawCard& card, double radius_m, double delta_bar) {
  TwoParameters p;
  p.radius_m = radius_m, p.delta_bar = delta_bar;
  if (p.delta_bar == 0) {
    if (!card.delta_bar)
      throw core::InvalidInput(
          fmt::format("{}: the card does not say how far the law holds; give --delta-bar", card.file));
    p.delta_bar = (*card.delta_bar)[1];
  }
  if (!(p.delta_bar > 0 && p.delta_bar <= 1))
    throw core::InvalidInput(
        fmt::format("--delta-bar {}: it must be a number in (0, 1]", core::number_text(p.delta_bar)));
  const law::Law law = fit::make_law(card, {{"radius_m", core::number_text(radius_m)}});
  if (const auto nu = card.parameters.find("nu"); nu != card.parameters.end())
    if (const auto number = core::number_from(nu->second)) p.nu = *number, p.nu_given = true;
  const double end = 2 * radius_m * p.delta_bar;
  std::vector<double> force, hertz, line;
  for (int i = 0; i <= steps; ++i) {
    const double gamma = end * i / steps;
    force.push_back(law::evaluate(law, {}, gamma).force);
    hertz.push_back(4.0 / 3 * std::sqrt(radius_m / 2) * gamma * std::sqrt(gamma));
    line.push_back(gamma);
  }
  if (!(force.back() > 0)) throw core::InvalidInput(fmt::format("{}: the law has no force there", card.file));
  const auto [E_star, hertz_error] = nearest(force, hertz);
  const auto [k_1, springs_error] = nearest(force, line);
  p.E_Pa = 2 * (1 - p.nu * p.nu) * E_star, p.hertz_error = hertz_error;
  p.k_1_N_per_m = k_1, p.springs_error = springs_error;
  p.restitution = restitution_of(law, end);
  p.k_2_N_per_m = p.k_1_N_per_m / (p.restitution * p.restitution);
  for (const double part : {0.01, 0.1, 0.3, 1.0})
    p.restitutions.push_back({part * p.delta_bar, restitution_of(law, part * end)});
  return p;
}

std::string words_of(const TwoParameters& p, const fit::LawCard& card) {
  std::string text = fmt::format(
      "# Law {} of {}: two spheres of radius {} m, to delta/R = {}.\n"
      "# The nearest laws of two numbers; force: relative L2 over the loading.\n"
      "hertz    E_Pa = {:.4g}, nu = {:.4g}{}, restitution = {:.3f}; force off by {:.2g} %\n"
      "springs  k_1_N_per_m = {:.4g}, k_2_N_per_m = {:.4g} (restitution {:.3f}); force off by {:.2g} %\n"
      "# restitution of the law, sqrt(work given back/work spent):",
      card.law, std::filesystem::path(card.file).filename().string(), core::number_text(p.radius_m),
      core::number_text(p.delta_bar), p.E_Pa, p.nu, p.nu_given ? "" : " (assumed)", p.restitution,
      100 * p.hertz_error, p.k_1_N_per_m, p.k_2_N_per_m, p.restitution, 100 * p.springs_error);
  for (const auto& [delta_bar, e] : p.restitutions) text += fmt::format(" {:.3f} at {:.3g},", e, delta_bar);
  text.back() = '\n';
  return text;
}

} // namespace platen::dem
