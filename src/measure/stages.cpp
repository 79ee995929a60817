#include "measure/stages.hpp"

#include "fit/onset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace platen::measure {
namespace {

using Numbers = std::vector<double>;

double median(Numbers v) {
  if (v.empty()) return 0;
  const auto middle = v.begin() + static_cast<long>(v.size() / 2);
  std::nth_element(v.begin(), middle, v.end());
  return *middle;
}

/// Standard deviation of white noise on a smooth curve: second differences have six times its variance.
double noise(const Numbers& v) {
  Numbers differences;
  for (std::size_t i = 1; i + 1 < v.size(); ++i)
    differences.push_back(std::abs(v[i - 1] - 2 * v[i] + v[i + 1]));
  return 1.4826 * median(std::move(differences)) / std::sqrt(6.0);
}

/// Rows where the direction turns by more than `least`, both ends included; highs and lows in turn.
std::vector<std::size_t> turns(const Numbers& x, double least) {
  std::vector<std::size_t> rows = {0};
  std::size_t high = 0, low = 0;
  int direction = 0;
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (x[i] > x[high]) high = i;
    if (x[i] < x[low]) low = i;
    if (direction >= 0 && x[high] - x[i] > least) {
      if (direction > 0 || high > 0) rows.push_back(high);
      direction = -1;
      low = i;
    } else if (direction <= 0 && x[i] - x[low] > least) {
      if (direction < 0 || low > 0) rows.push_back(low);
      direction = 1;
      high = i;
    }
  }
  rows.push_back(x.size() - 1);
  return rows;
}

/// Stretches where the platens stand: far more rows within a narrow band than on the way elsewhere. A stiff
/// particle unloads over as little way, and its force shows it.
void mark_holds(const Numbers& x, const Numbers& F, double range, double travel_noise, Stages& stages) {
  constexpr double unloads = 0.05; // of the largest force
  const double F_max = *std::ranges::max_element(F);
  const auto is_way_back = [&](std::size_t i, std::size_t end) {
    const auto stage = stages.of_row[(i + end) / 2];
    const auto [least, most] =
        std::minmax_element(F.begin() + static_cast<long>(i), F.begin() + static_cast<long>(end));
    return (stage == Stage::unloading || stage == Stage::reloading) && *most - *least > unloads * F_max;
  };
  constexpr double band_share = 1e-3;
  const double band = std::max(4 * travel_noise, band_share * range);
  Numbers steps; // over several rows, since travel that is written with few digits stands still in between
  const std::size_t apart = std::max<std::size_t>(1, x.size() / 2000);
  for (std::size_t i = apart; i < x.size(); i += apart)
    steps.push_back(std::abs(x[i] - x[i - apart]) / static_cast<double>(apart));
  const double usual = median(std::move(steps));
  if (!(usual > 0)) return;
  const auto least = static_cast<std::size_t>(std::clamp(6 * band / usual, 5.0, 1e9));
  for (std::size_t i = 0; i < x.size();) {
    std::size_t end = i + 1;
    double low = x[i], high = x[i];
    while (end < x.size() && std::max(high, x[end]) - std::min(low, x[end]) <= band) {
      low = std::min(low, x[end]), high = std::max(high, x[end]);
      ++end;
    }
    if (end - i >= least && !is_way_back(i, end)) {
      for (std::size_t k = i; k < end; ++k) stages.of_row[k] = Stage::hold;
      ++stages.holds;
      i = end;
    } else i += std::max<std::size_t>(1, (end - i) / 8);
  }
}

/// Of a whole particle's force only noise is lost while the platens close. A loop takes nothing from the
/// force to come back to; a break, under which the frame springs back, may look like one.
std::optional<Break> find_break(const Numbers& F, const Stages& stages) {
  constexpr double least_share = 0.1;
  const double F_max = *std::ranges::max_element(F);
  double loaded = 0, reloaded = 0; // highest so far on the loading curve, and in this reloading
  for (std::size_t i = 0; i < F.size(); ++i) {
    const Stage stage = stages.of_row[i];
    if (stage == Stage::hold && i > 0 && stages.of_row[i - 1] != Stage::hold) loaded = 0; // it may relax
    if (stage == Stage::unloading) reloaded = 0;
    if (stage != Stage::loading && stage != Stage::reloading) continue;
    double& highest = stage == Stage::loading ? loaded : reloaded;
    if (highest > 0.1 * F_max && highest > 20 * stages.force_noise_N) {
      const double now = i + 1 < F.size() && stages.of_row[i + 1] == stage ? std::max(F[i], F[i + 1]) : F[i];
      const double fell = highest - now;
      if (fell > least_share * highest && fell > 8 * stages.force_noise_N) return Break{i, fell / highest};
    }
    highest = std::max(highest, F[i]);
  }
  return {};
}

} // namespace

std::string_view name_of(Stage stage) {
  constexpr std::string_view names[] = {"approach", "loading", "hold", "unloading", "reloading", "broken"};
  return names[static_cast<int>(stage)];
}

std::string Stages::words() const {
  const auto count = [](int n, std::string_view word) {
    return fmt::format("{} {}{}", n, word, n == 1 ? "" : "s");
  };
  std::string text = count(holds, "hold");
  if (loops > 0) text += ", " + count(loops, "loop");
  return text + ", " + count(unloadings - loops, loops > 0 ? "last unloading" : "unloading");
}

Stages stages_of(const Specimen& s) {
  const auto& x = s.travel_m;
  const auto& F = s.force_N;
  Stages stages;
  stages.of_row.assign(x.size(), Stage::loading);
  stages.travel_noise_m = noise(x);
  stages.force_noise_N = noise(F);
  const auto [low, high] = std::ranges::minmax(x);
  const double range = high - low;
  if (!(range > 0)) return stages;
  constexpr double shortest = 5e-4; // of the range: a stiff metal comes back by so little
  const auto rows = turns(x, std::max(6 * stages.travel_noise_m, shortest * range));
  double highest = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k + 1 < rows.size(); ++k) {
    const bool opens = x[rows[k + 1]] < x[rows[k]];
    if (opens) ++stages.unloadings;
    else if (k > 0) ++stages.loops;
    for (std::size_t i = rows[k] + (k > 0); i <= rows[k + 1]; ++i) {
      stages.of_row[i] = opens ? Stage::unloading : x[i] < highest ? Stage::reloading : Stage::loading;
      if (!opens) highest = std::max(highest, x[i]);
      if (!opens && k == 0) stages.of_row[i] = Stage::loading;
    }
  }
  mark_holds(x, F, range, stages.travel_noise_m, stages);
  stages.broke = find_break(F, stages);
  const std::size_t peak = rows.size() > 1 ? rows[1] : x.size() - 1;
  const auto end = static_cast<long>(std::max<std::size_t>(stages.broke ? stages.broke->row : peak, 2));
  const auto onset =
      fit::find_onset({x.begin(), x.begin() + end}, {F.begin(), F.begin() + end}, stages.force_noise_N);
  stages.contact_travel_m = onset.x;
  stages.contact_uncertainty_m = onset.uncertainty;
  stages.baseline_N = onset.baseline;
  stages.baseline_rows = onset.rows_before;
  for (std::size_t i = 0; i < x.size() && i <= peak && x[i] < stages.contact_travel_m; ++i)
    stages.of_row[i] = Stage::approach;
  if (stages.broke)
    for (std::size_t i = stages.broke->row; i < x.size(); ++i) stages.of_row[i] = Stage::broken;
  return stages;
}

} // namespace platen::measure
