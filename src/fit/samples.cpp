#include "fit/samples.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace platen::fit {

namespace {

/// Three parameters want a few points on either side of the kink.
constexpr std::size_t fewest_points = 8;

} // namespace

std::vector<double> trapezoid_weights(const std::vector<double>& x, double from) {
  std::vector<double> weight(x.size(), 0);
  if (x.empty()) return weight;
  weight.front() += (x.front() - from) / 2; // the curve starts at rest: nothing at `from`
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    weight[i] += (x[i + 1] - x[i]) / 2;
    weight[i + 1] += (x[i + 1] - x[i]) / 2;
  }
  return weight;
}

std::vector<double> growing(std::vector<double> y, double least_step) {
  std::vector<std::pair<double, int>> blocks; // mean, count
  for (const double v : y) {
    blocks.emplace_back(v, 1);
    while (blocks.size() > 1 && blocks[blocks.size() - 2].first > blocks.back().first) {
      const auto [mean, count] = blocks.back();
      blocks.pop_back();
      auto& last = blocks.back();
      last.first = (last.first * last.second + mean * count) / (last.second + count);
      last.second += count;
    }
  }
  std::size_t i = 0;
  for (const auto& [mean, count] : blocks)
    for (int k = 0; k < count; ++k, ++i) y[i] = mean * (1 + least_step * (k - (count - 1) / 2.0));
  return y;
}

void refuse_beyond_squares(const std::vector<double>& F_bar) {
  constexpr double least = 1e-60, most = 1e60; // squares, and their ratios, are finite
  double largest = 0;
  for (const double F : F_bar) largest = std::max(largest, std::abs(F));
  if (!(largest >= least && largest <= most))
    throw core::InvalidInput(
        fmt::format("the largest force is F_bar = {:.3g}, which no particle has: force, radius or reference "
                    "stress are in other units",
                    largest));
}

Samples loading_samples(const press::Curve& curve) {
  Samples samples;
  for (const auto& point : curve.points) {
    if (point.branch != press::Branch::loading) continue;
    if (!std::isfinite(point.delta_bar) || !std::isfinite(point.F_bar))
      throw core::InvalidInput(fmt::format("the loading branch is not finite after delta_bar = {:g}",
                                           samples.size() ? samples.delta_bar.back() : 0.0));
    if (samples.size() && !(point.delta_bar > samples.delta_bar.back()))
      throw core::InvalidInput(
          fmt::format("the loading branch does not ascend in delta_bar: {:g} comes after {:g}",
                      point.delta_bar, samples.delta_bar.back()));
    if (point.delta_bar < 0)
      throw core::InvalidInput(
          fmt::format("the loading branch has delta_bar = {:g}; overlaps start at 0", point.delta_bar));
    samples.delta_bar.push_back(point.delta_bar);
    samples.F_bar.push_back(point.F_bar);
  }
  if (samples.size() < fewest_points)
    throw core::InvalidInput(fmt::format("the loading branch has {} points; a fit needs at least {}",
                                         samples.size(), fewest_points));
  if (*std::max_element(samples.F_bar.begin(), samples.F_bar.end()) <= 0)
    throw core::InvalidInput("the loading branch has no point with a positive force");
  if (samples.F_bar.back() <= 0)
    throw core::InvalidInput(fmt::format(
        "the loading branch ends with the force F_bar = {:g}; it must be positive", samples.F_bar.back()));
  refuse_beyond_squares(samples.F_bar);
  samples.weight = trapezoid_weights(samples.delta_bar, 0);
  return samples;
}

Errors errors(const Samples& samples, const std::vector<double>& F_bar_law) {
  double squares = 0, force_squares = 0, force = 0, peak = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double residual = F_bar_law[i] - samples.F_bar[i];
    squares += samples.weight[i] * residual * residual;
    force_squares += samples.weight[i] * samples.F_bar[i] * samples.F_bar[i];
    force += samples.weight[i] * samples.F_bar[i];
    peak = std::max(peak, std::abs(residual));
  }
  return {std::sqrt(squares / force_squares), peak / samples.F_bar.back(), std::sqrt(squares) / force};
}

double r_squared(const Samples& samples, const std::vector<double>& F_bar_law) {
  double length = 0, mean = 0, squares = 0, spread = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    length += samples.weight[i];
    mean += samples.weight[i] * samples.F_bar[i];
  }
  mean /= length;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    squares += samples.weight[i] * std::pow(F_bar_law[i] - samples.F_bar[i], 2);
    spread += samples.weight[i] * std::pow(samples.F_bar[i] - mean, 2);
  }
  return 1 - squares / spread;
}

} // namespace platen::fit
