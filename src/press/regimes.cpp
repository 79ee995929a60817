#include "press/regimes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace platen::press {
namespace {

constexpr std::size_t fewest_points = 8, fewest_in_window = 7;
constexpr int intervals = 400;

struct Local {
  double value, slope;
};

/// Least squares over the points of `x` within `half` of `at`, the nearest ones where they are too few.
Local local_quadratic(const std::vector<double>& x, const std::vector<double>& y, double at, double half) {
  std::vector<double> distances;
  for (const double here : x) distances.push_back(std::abs(here - at));
  std::nth_element(distances.begin(), distances.begin() + fewest_in_window - 1, distances.end());
  half = std::max(half, distances[fewest_in_window - 1]);
  std::array<double, 5> moment{}; // sums of t^k
  std::array<double, 3> product{};
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double t = (x[i] - at) / half;
    if (std::abs(t) > 1) continue;
    double power = 1;
    for (std::size_t k = 0; k < 5; ++k, power *= t) {
      moment[k] += power;
      if (k < 3) product[k] += power * y[i];
    }
  }
  // Three normal equations of t within [-1, 1], by cofactors.
  const auto& m = moment;
  const double c00 = m[2] * m[4] - m[3] * m[3], c01 = m[2] * m[3] - m[1] * m[4],
               c02 = m[1] * m[3] - m[2] * m[2], c11 = m[0] * m[4] - m[2] * m[2],
               c12 = m[1] * m[2] - m[0] * m[3];
  const double determinant = m[0] * c00 + m[1] * c01 + m[2] * c02;
  return {(c00 * product[0] + c01 * product[1] + c02 * product[2]) / determinant,
          (c01 * product[0] + c11 * product[1] + c12 * product[2]) / determinant / half};
}

struct Loading {
  std::vector<double> delta_bar, pressure, work, stored, dissipated;

  [[nodiscard]] double half_width(double x) const { return std::min(x / 2, delta_bar.back() / 7); }
  [[nodiscard]] double smooth_pressure(double x) const {
    return local_quadratic(delta_bar, pressure, x, half_width(x)).value;
  }
  [[nodiscard]] double stored_share(double x) const {
    return local_quadratic(delta_bar, stored, x, half_width(x)).slope /
           local_quadratic(delta_bar, work, x, half_width(x)).slope;
  }
};

Loading loading_of(const Curve& curve) {
  Loading l;
  for (const auto& p : curve.points) {
    if (p.branch != Branch::loading || !(p.delta_bar > (l.delta_bar.empty() ? 0 : l.delta_bar.back())))
      continue;
    l.delta_bar.push_back(p.delta_bar);
    l.pressure.push_back(p.mean_pressure_Pa);
    l.work.push_back(p.work_J);
    l.stored.push_back(p.stored_J);
    l.dissipated.push_back(p.dissipated_J);
  }
  return l;
}

void find_first_yield(const Loading& l, Regimes& found) {
  double before = 0;
  for (std::size_t i = 0; i < l.delta_bar.size(); ++i) {
    if (!(l.work[i] > 0)) continue;
    const double share = l.dissipated[i] / l.work[i];
    if (share > yield_share) {
      found.yields_in_first_row = i == 0;
      found.elastic_plastic = i == 0 ? l.delta_bar[0]
                                     : l.delta_bar[i] - (share - yield_share) / (share - before) *
                                                            (l.delta_bar[i] - l.delta_bar[i - 1]);
      return;
    }
    before = share;
  }
}

/// The maximum and minimum between which pressure falls most, so that a scallop is not taken for either; the
/// minimum only where pressure rises enough after it.
void find_turns(const Loading& l, Regimes& found) {
  const double from = *found.elastic_plastic, ratio = l.delta_bar.back() / from;
  double highest = 0, highest_at = from, rise = 1, most_fall = 1 - least_turn, lowest_at = from, lowest = 0;
  for (int i = 0; i <= intervals; ++i) {
    const double x = from * std::pow(ratio, double(i) / intervals);
    const double p = l.smooth_pressure(x);
    if (p > highest) highest = p, highest_at = x;
    if (p < most_fall * highest) {
      most_fall = p / highest;
      found.plastic = highest_at;
      lowest = p, lowest_at = x, rise = 1;
    }
    if (lowest > 0) rise = std::max(rise, p / lowest);
  }
  if (rise > 1 + least_turn) found.low_compressibility = lowest_at;
}

void find_elastic_volumetric(const Loading& l, Regimes& found) {
  const double from = *found.low_compressibility, end = l.delta_bar.back();
  for (int i = 0; i <= intervals; ++i) {
    const double x = from + (end - from) * i / intervals;
    if (l.stored_share(x) > 0.5) {
      found.elastic_volumetric = x;
      return;
    }
  }
}

} // namespace

const std::vector<RegimeBoundary>& regime_boundaries() {
  static const std::vector<RegimeBoundary> boundaries = {
      {"elastic_plastic", "elastic-plastic", "dissipated energy passes 0.1 % of the work",
       &Regimes::elastic_plastic},
      {"plastic", "plastic", "maximum of the smoothed mean pressure after first yield", &Regimes::plastic},
      {"low_compressibility", "low compressibility",
       "minimum of the smoothed mean pressure after that maximum", &Regimes::low_compressibility},
      {"elastic_volumetric", "elastic volumetric", "more than half of the rate of work is stored again",
       &Regimes::elastic_volumetric}};
  return boundaries;
}

Regimes regimes(const Curve& curve) {
  const Loading l = loading_of(curve);
  Regimes found;
  if (l.delta_bar.size() < fewest_points || !(l.work.back() > 0)) return found;
  found.stored_share_at_end = l.stored_share(l.delta_bar.back());
  find_first_yield(l, found);
  if (found.elastic_plastic) find_turns(l, found);
  if (found.low_compressibility) find_elastic_volumetric(l, found);
  return found;
}

std::string regimes_words(const Regimes& found) {
  std::string words = "regimes over delta_bar:\n";
  for (const auto& boundary : regime_boundaries()) {
    const auto& at = found.*boundary.delta_bar;
    words += at ? fmt::format("  {:<20} from {}{:.4g}: {}\n", boundary.name,
                              boundary.delta_bar == &Regimes::elastic_plastic && found.yields_in_first_row
                                  ? "at most "
                                  : "",
                              *at, boundary.criterion)
                : fmt::format("  {:<20} not reached\n", boundary.name);
  }
  if (found.stored_share_at_end)
    words += fmt::format("  of the rate of work at the end {:.2g} is stored\n", *found.stored_share_at_end);
  return words;
}

} // namespace platen::press
