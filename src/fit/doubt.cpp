#include "fit/doubt.hpp"

#include "core/error.hpp"
#include "fit/onset.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace platen::fit {
namespace {

// Bounds of what is believed. Materials of the papers have E/sigma_y from 3 (soft granules) to 6,000
// (metals).
constexpr double delta_bar_refused = 1, delta_bar_usual = 0.5;
constexpr double ratio_least = 3, ratio_most = 1e5;
constexpr double R2_refused = 0.9, R2_usual = 0.98;
constexpr double stiffer_than_Hertz = 1.3;                  // noise, and the finite sphere, allow this much
constexpr double softer_than_Hertz = 5e-4;                  // E/sigma_y = 10^4 begins ten times as stiff
constexpr double gap_refused = 0.03, offset_refused = 0.03; // of the way, of the largest force
constexpr double loaded = 0.03;                             // of the largest force
constexpr double straight_R2 = 0.9999, straight_delta_bar = 0.05;

struct Reading {
  std::string_view words;
  double factor;
};

class Gate {
 public:
  explicit Gate(const Claim& claim) : c_(claim) {
    for (double delta : c_.delta_m) delta_bar_ = std::max(delta_bar_, delta / c_.radius_m);
    for (double F : c_.force_N) force_max_ = std::max(force_max_, F);
  }

  std::vector<Doubt> doubts() {
    overlap();
    start();
    dropout();
    straight_line();
    stiffness();
    strength();
    quality();
    return std::move(doubts_);
  }

 private:
  void say(bool refuses, std::string sentence) {
    doubts_.push_back(
        {refuses, c_.name.empty() ? std::move(sentence) : fmt::format("{}: {}", c_.name, sentence)});
  }

  void overlap() {
    if (!(delta_bar_ > std::max(c_.valid_to, 0.0) * (1 + 1e-9))) return;
    std::string sense;
    for (const auto& [words, factor] :
         {Reading{"mm instead of m", 1e-3}, Reading{"um instead of m, or of a length in mm taken as m", 1e-6},
          Reading{"the travel between two platens instead of delta", 0.5}})
      if (sense.empty() && delta_bar_ * factor < 1.001 * delta_bar_usual && delta_bar_ * factor > 5e-3)
        sense = fmt::format("; with {}, delta/R would end at {:.2g}", words, delta_bar_ * factor);
    const bool refuses = delta_bar_ > delta_bar_refused;
    say(refuses, fmt::format("delta/R ends at {:.3g}, {}{}", delta_bar_,
                             refuses ? "more than the particle has"
                                     : fmt::format("and the law holds to {:.3g}", c_.valid_to),
                             sense));
  }

  /// Force that begins late, or is there before contact: a gap, a load cell off zero.
  void start() {
    if (c_.contact_known || c_.force_N.size() < 8) return;
    const double delta_max = delta_bar_ * c_.radius_m;
    const Onset onset = find_onset(c_.delta_m, c_.force_N, 0, 2);
    const double share = (onset.x - std::max(0.0, c_.delta_m.front())) / delta_max;
    if (share > gap_refused && onset.x > 3 * onset.uncertainty)
      say(true,
          fmt::format("force begins at delta = {:.3g} um, {:.2g} of the way: the platens were not in contact "
                      "before; platen calibrate finds the contact point",
                      onset.x * 1e6, share));
    const double at_start = c_.force_N.front();
    if (c_.delta_m.front() < 2e-3 * delta_max && std::abs(at_start) > offset_refused * force_max_)
      say(true,
          fmt::format("the force is {:.3g} N, {:.2g} of the largest, where delta is 0: the load cell is off "
                      "zero, or the travel begins after contact; platen calibrate finds both",
                      at_start, at_start / force_max_));
  }

  /// While the platens approach, a particle that carried force goes on to carry some. Where the contact point
  /// was fitted, loops are among the rows, and R2 tells.
  void dropout() {
    if (c_.contact_known) return;
    double before = 0;
    for (std::size_t i = 0; i < c_.force_N.size(); ++i) {
      const double F = c_.force_N[i];
      if (F <= 0 && before > loaded * force_max_)
        return say(true,
                   fmt::format("the force is {:.3g} N at delta = {:.4g} um, and was {:.3g} N before: the "
                               "load cell lost it, or the particle broke; cut the file there, or leave "
                               "such rows out",
                               F, c_.delta_m[i] * 1e6, before));
      before = std::max(before, F);
    }
  }

  /// A frame without a particle in it gives force in proportion to travel. A particle does not: it begins
  /// as Hertz's.
  void straight_line() {
    double n = 0, mx = 0, mF = 0, xx = 0, xF = 0, FF = 0;
    const auto counts = [&](std::size_t i) { return c_.force_N[i] > 0.02 * force_max_; };
    for (std::size_t i = 0; i < c_.force_N.size(); ++i)
      if (counts(i)) mx += c_.delta_m[i], mF += c_.force_N[i], n += 1;
    if (n < 8) return;
    for (std::size_t i = 0; i < c_.force_N.size(); ++i)
      if (counts(i)) {
        const double dx = c_.delta_m[i] - mx / n, dF = c_.force_N[i] - mF / n;
        xx += dx * dx, xF += dx * dF, FF += dF * dF;
      }
    const double line_R2 = xF * xF / (xx * FF);
    if (line_R2 > straight_R2 && delta_bar_ < straight_delta_bar)
      say(true,
          fmt::format("force is proportional to overlap (R2 of a straight line {:.6f}, {:.3g} N/um), as of a "
                      "machine with no particle in it",
                      line_R2, xF / xx * 1e-6));
  }

  /// Of the foot of the curve, over Hertz's: 4/3 E/(1 - nu^2) sqrt(R) delta^(3/2).
  void stiffness() {
    if (!c_.E_Pa) return;
    const double nu = c_.nu.value_or(0.3), E_star = *c_.E_Pa / (1 - nu * nu);
    std::vector<double> ratios;
    for (std::size_t i = 0; i < c_.force_N.size() && ratios.size() < 15; ++i)
      if (c_.delta_m[i] > 0 && c_.force_N[i] > 0.05 * force_max_)
        ratios.push_back(c_.force_N[i] /
                         (4.0 / 3 * E_star * std::sqrt(c_.radius_m) * std::pow(c_.delta_m[i], 1.5)));
    if (ratios.size() < 3) return;
    std::ranges::nth_element(ratios, ratios.begin() + static_cast<long>(ratios.size() / 2));
    const double ratio = ratios[ratios.size() / 2];
    if (ratio > stiffer_than_Hertz)
      say(true,
          fmt::format("it begins {:.3g} times as stiff as an elastic sphere of E = {:.3g} Pa can be; E would "
                      "have to be {:.2g} Pa at least, or force, displacement and radius are in other units",
                      ratio, *c_.E_Pa, ratio * *c_.E_Pa));
    else if (ratio < softer_than_Hertz)
      say(false,
          fmt::format("it begins {:.2g} times as stiff as an elastic sphere of E = {:.3g} Pa; are E and the "
                      "units right?",
                      ratio, *c_.E_Pa));
  }

  void strength() {
    if (!c_.strength_Pa || !c_.E_Pa) return;
    const double ratio = *c_.E_Pa / *c_.strength_Pa;
    if (ratio <= 1)
      say(true,
          fmt::format("the strength, {:.3g} Pa, is above the modulus, {:.3g} Pa", *c_.strength_Pa, *c_.E_Pa));
    else if (!(ratio >= ratio_least && ratio <= ratio_most))
      say(true, fmt::format("E over strength is {:.3g}; materials have {} to {:.0e}", ratio, ratio_least,
                            ratio_most));
  }

  void quality() {
    const auto below = [this](double bound) { return c_.R2 && !(*c_.R2 >= bound); }; // so is no number
    if (below(R2_usual))
      say(below(R2_refused), fmt::format("the law follows the curve with R2 = {:.3g} only{}", *c_.R2,
                                         below(R2_refused) ? "; did the particle break?" : ""));
    if (!c_.on_bound.empty())
      say(true,
          fmt::format("{} ended on {} bound: the curve does not determine {}", fmt::join(c_.on_bound, ", "),
                      c_.on_bound.size() == 1 ? "its" : "their", c_.on_bound.size() == 1 ? "it" : "them"));
  }

  const Claim& c_;
  double delta_bar_ = 0, force_max_ = 0;
  std::vector<Doubt> doubts_;
};

} // namespace

std::vector<Doubt> doubts_about(const Claim& claim) { return Gate(claim).doubts(); }

std::vector<std::string> pass(const std::vector<Doubt>& doubts, bool force) {
  std::vector<std::string> kept, refused;
  for (const auto& doubt : doubts) (doubt.refuses && !force ? refused : kept).push_back(doubt.sentence);
  if (!refused.empty())
    throw core::InvalidInput(fmt::format("{}; --force writes it all the same", fmt::join(refused, "; ")));
  return kept;
}

} // namespace platen::fit
