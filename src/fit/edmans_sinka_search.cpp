#include "fit/edmans_sinka_search.hpp"

#include "core/error.hpp"
#include "fit/golden.hpp"
#include "fit/solve.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace platen::fit {

namespace {

constexpr double a_least = 1e-3, a_most = 50; ///< what the law accepts is in (0, 50]
constexpr std::size_t scanned_rates = 18, scanned_kinks = 200, polished_kinks = 12;

/// sqrt(weight) (F_law - F) of every sample, scaled so that the sum of squares is the relative L2 error
/// squared.
struct Residuals {
  const Samples& samples;
  law::EdmansSinkaVariant variant;
  double scale;

  template <class Real>
  bool operator()(const Real* k, const Real* delta_t, const Real* a, Real* residual) const {
    law::EdmansSinkaCurve<Real> curve;
    curve.k = *k;
    curve.delta_t = *delta_t;
    curve.a = *a;
    curve.variant = variant;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double x = samples.delta_bar[i];
      // at x = 0 every variant is 0, but not every one can be differentiated there
      const Real F_law = x > 0 ? curve.F_bar(Real(x)) : Real(0);
      residual[i] = std::sqrt(samples.weight[i]) * scale * (F_law - samples.F_bar[i]);
    }
    return true;
  }
};

/// ln a.
std::vector<double> candidate_rates() {
  std::vector<double> rates;
  const double lowest = 0.05; // a gentler rise cannot be told from a plateau within delta_bar <= 0.5
  for (std::size_t i = 0; i < scanned_rates; ++i)
    rates.push_back(std::log(lowest) +
                    std::log(a_most / lowest) * static_cast<double>(i) / (scanned_rates - 1));
  return rates;
}

} // namespace

EdmansSinkaSearch::EdmansSinkaSearch(const Samples& samples, law::EdmansSinkaVariant variant)
    : samples_(samples), variant_(variant) {
  for (std::size_t i = 0; i < samples.size(); ++i)
    force_squares_ += samples.weight[i] * samples.F_bar[i] * samples.F_bar[i];
  // one sample below the kink and three above it at least, or the branch is not determined
  const std::size_t first = samples.delta_bar.front() > 0 ? 0 : 1;
  bounds_ = {{0, samples.delta_bar[first], a_least},
             {INFINITY, samples.delta_bar[samples.size() - 4], a_most}};
}

/// Samples and the middles between them; fewer on a long curve.
std::vector<double> EdmansSinkaSearch::candidate_kinks() const {
  const auto& x = samples_.delta_bar;
  const std::size_t stride = x.size() / scanned_kinks + 1;
  std::vector<double> kinks;
  const auto add = [&](double delta_t) {
    if (delta_t >= bounds_.low[1] && delta_t <= bounds_.high[1]) kinks.push_back(delta_t);
  };
  for (std::size_t i = 0; i + stride < x.size(); i += stride) {
    add(x[i]);
    if (2 * x.size() <= scanned_kinks) add((x[i] + x[i + stride]) / 2);
  }
  if (kinks.empty()) kinks.push_back(bounds_.low[1]);
  return kinks;
}

EdmansSinkaSearch::Projected EdmansSinkaSearch::projected(double delta_t, double a) const {
  law::EdmansSinkaCurve<double> shape;
  shape.k = 1;
  shape.delta_t = delta_t;
  shape.a = a;
  shape.variant = variant_;
  double product = 0, square = 0;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const double value = shape.F_bar(samples_.delta_bar[i]);
    product += samples_.weight[i] * value * samples_.F_bar[i];
    square += samples_.weight[i] * value * value;
  }
  if (!(product > 0)) return {};
  return {product / square, 1 - product / square * product / force_squares_};
}

EdmansSinkaSearch::Found EdmansSinkaSearch::polished(EdmansSinkaParameters start,
                                                     const EdmansSinkaBounds& bounds,
                                                     std::optional<std::size_t> held) const {
  EdmansSinkaParameters p = start;
  for (std::size_t i = 0; i < 3; ++i) p[i] = std::clamp(p[i], bounds.low[i], bounds.high[i]);
  ceres::Problem problem;
  problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Residuals, ceres::DYNAMIC, 1, 1, 1>(
                               new Residuals{samples_, variant_, 1 / std::sqrt(force_squares_)},
                               static_cast<int>(samples_.size())),
                           nullptr, &p[0], &p[1], &p[2]);
  for (std::size_t i = 0; i < 3; ++i) {
    if (i == held) {
      problem.SetParameterBlockConstant(&p[i]);
      continue;
    }
    problem.SetParameterLowerBound(&p[i], 0, bounds.low[i]);
    if (std::isfinite(bounds.high[i])) problem.SetParameterUpperBound(&p[i], 0, bounds.high[i]);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = 100;
  options.function_tolerance = 1e-13;
  options.parameter_tolerance = 1e-12;
  options.gradient_tolerance = 1e-15;
  const auto summary = solve(problem, options);
  if (!summary.IsSolutionUsable()) return {start, INFINITY};
  return {p, std::sqrt(2 * summary.final_cost)};
}

/// Smallest error for one delta_t: a scanned and refined, k projected out.
EdmansSinkaSearch::Found EdmansSinkaSearch::profile(double delta_t, const std::vector<double>& rates) const {
  constexpr int refinements = 14; // 0.618^14 of two steps of the scan: a to a part in a thousand
  const auto squares = [&](double log_a) { return projected(delta_t, std::exp(log_a)).relative_squares; };
  const Minimum best = scanned_minimum(squares, rates, refinements);
  const double a = std::exp(best.at);
  return {{projected(delta_t, a).k, delta_t, a}, std::sqrt(std::max(0.0, best.value))};
}

/// Polishes in every stretch between two samples that touches [low, high].
EdmansSinkaSearch::Found EdmansSinkaSearch::polished_between(double low, double high,
                                                             const Found& start) const {
  const auto& x = samples_.delta_bar;
  Found best = start;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    if (x[i + 1] <= low || x[i] >= high) continue;
    EdmansSinkaBounds within = bounds_;
    within.low[1] = std::max(bounds_.low[1], x[i]);
    within.high[1] = std::min(bounds_.high[1], x[i + 1]);
    if (!(within.low[1] < within.high[1])) continue;
    const Found here = polished(start.parameters, within, std::nullopt);
    if (here.relative_l2 < best.relative_l2) best = here;
  }
  return best;
}

EdmansSinkaSearch::Found EdmansSinkaSearch::best() const {
  const std::vector<double> rates = candidate_rates(), kinks = candidate_kinks();
  std::vector<Found> scan;
  for (const double delta_t : kinks) scan.push_back(profile(delta_t, rates));
  std::vector<std::size_t> order(scan.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](auto one, auto other) { return scan[one].relative_l2 < scan[other].relative_l2; });
  order.resize(std::min(order.size(), polished_kinks));

  Found result{{}, INFINITY};
  for (const std::size_t i : order) {
    const double low = i > 0 ? (kinks[i - 1] + kinks[i]) / 2 : kinks[i];
    const double high = i + 1 < kinks.size() ? (kinks[i] + kinks[i + 1]) / 2 : kinks[i];
    const Found found = polished_between(low, high, scan[i]);
    if (found.relative_l2 < result.relative_l2) result = found;
  }
  if (!std::isfinite(result.relative_l2))
    throw core::ConvergenceError("the fit of edmans-sinka found no minimum", 0, 0, result.relative_l2);
  return result;
}

EdmansSinkaSearch::Found EdmansSinkaSearch::best_with(std::size_t held, double value,
                                                      EdmansSinkaParameters near) const {
  near[held] = value;
  EdmansSinkaBounds bounds = bounds_;
  bounds.low[held] = bounds.high[held] = value;
  return polished(near, bounds, held);
}

} // namespace platen::fit
