#include "calibrate/search.hpp"

#include "calibrate/problem.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace platen::calibrate {
namespace {

constexpr double no_effect = 1e-9; // of the longest column of the Jacobian

/// (J^T J)^-1 with columns in units of their own length; what has no effect is left out of the inversion.
struct Curvature {
  Eigen::MatrixXd scaled, inverse;
  Eigen::VectorXd length;

  explicit Curvature(Eigen::MatrixXd J) : scaled(std::move(J)), length(scaled.colwise().norm()) {
    for (Eigen::Index k = 0; k < scaled.cols(); ++k)
      scaled.col(k) /= acts(k) ? length[k] : std::numeric_limits<double>::infinity();
    inverse = (scaled.transpose() * scaled).completeOrthogonalDecomposition().pseudoInverse();
  }
  bool acts(Eigen::Index k) const { return length[k] > no_effect * length.maxCoeff(); }
  double deviation(const Eigen::MatrixXd& covariance, Eigen::Index k) const {
    return acts(k) ? std::sqrt(std::max(0.0, covariance(k, k))) / length[k]
                   : std::numeric_limits<double>::infinity();
  }
};

/// The covariance that comes from not knowing the law.
Eigen::MatrixXd of_the_law(Workshop& workshop, const std::vector<Samples>& samples, const State& state,
                           const Curvature& curvature) {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(curvature.inverse.rows(), curvature.inverse.cols());
  std::vector<double> force, other;
  const auto ways = workshop.astray(state.theta.data());
  for (const auto& way : ways) {
    Eigen::VectorXd off = Eigen::VectorXd::Zero(curvature.scaled.rows());
    Eigen::Index row = 0;
    for (std::size_t p = 0; p < samples.size(); ++p) {
      const auto& s = samples[p];
      const double contact = s.contact_guess_m + state.contact[p] * s.radius_m;
      workshop.predicted(s, state.theta.data(), contact, force);
      std::visit([&](const auto& one) { predict(one, workshop.made_for(s), s, contact, other); }, way);
      for (std::size_t i = 0; i < force.size(); ++i) off[row++] = (other[i] - force[i]) / s.sigma_N[i];
    }
    const Eigen::VectorXd shift = curvature.inverse * (curvature.scaled.transpose() * off);
    if (shift.allFinite()) sum += shift * shift.transpose();
  }
  return sum;
}

Own own_of(Workshop& workshop, const Samples& s, const State& state, std::size_t p) {
  Own own;
  own.contact_m = s.contact_guess_m + state.contact[p] * s.radius_m;
  own.baseline_fitted = zero_parameters(s) > 0, own.drift_fitted = zero_parameters(s) > 1;
  own.baseline_N = state.zero[p][0] * s.force_max_N, own.drift_N = state.zero[p][1] * s.force_max_N;
  workshop.predicted(s, state.theta.data(), own.contact_m, own.force_N);
  return own;
}

} // namespace

Trial trial(const Task& task, const Solution& best, const std::vector<double>& values) {
  Workshop workshop(task);
  const Coordinates c{task};
  State state = best.state;
  std::vector<int> all;
  for (std::size_t k = 0; k < values.size(); ++k) {
    all.push_back(static_cast<int>(k));
    if (task.free[k].logarithmic && !(values[k] > 0)) return {};
    state.theta[k] = c.inside(k, values[k]);
    const auto [low, high] = bounds(task, k);
    if (!(state.theta[k] >= low && state.theta[k] <= high)) return {};
  }
  if (!workshop.law(state.theta.data(), workshop.made_for(best.samples.front()))) return {};
  state = Problem(workshop, best.samples, std::move(state), all).solve();
  Trial t{2 * (state.cost - best.state.cost) / best.reduced_chi_squared, {}};
  for (std::size_t p = 0; p < best.samples.size(); ++p)
    t.own.push_back(own_of(workshop, best.samples[p], state, p));
  return t;
}

Solution solution_of(Workshop& workshop, std::vector<Samples> samples, State state) {
  const Task& task = workshop.task();
  const Coordinates c{task};
  const std::size_t n = samples.size(), free = task.free.size();
  Solution solution;
  solution.converged = state.converged;
  const Curvature curvature(Problem(workshop, samples, state).jacobian());
  const auto rows = curvature.scaled.rows(), columns = curvature.scaled.cols();
  solution.reduced_chi_squared = 2 * state.cost / std::max(1.0, static_cast<double>(rows - columns));
  const Eigen::MatrixXd noise = curvature.inverse * solution.reduced_chi_squared;
  const Eigen::MatrixXd covariance = noise + of_the_law(workshop, samples, state, curvature);
  for (std::size_t k = 0; k < free; ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    const double theta = state.theta[k], slope = c.slope(k, theta);
    solution.values.push_back(c.outside(k, theta));
    solution.errors.push_back(curvature.deviation(covariance, column) * slope);
    solution.noise_errors.push_back(curvature.deviation(noise, column) * slope);
    const auto [low, high] = bounds(task, k);
    const double near = on_bound_share * (high - low);
    // The law may end before the bound, as agarwal does where E is little above the strength.
    bool ends = false;
    for (const double step : {-near, near}) {
      auto beside = state.theta;
      beside[k] += step;
      ends = ends || !workshop.law(beside.data(), workshop.made_for(samples.front()));
    }
    if (ends) solution.errors.back() = solution.noise_errors.back() = std::numeric_limits<double>::infinity();
    solution.on_bound.push_back(ends || theta < low + 1.5 * near || theta > high - 1.5 * near);
    solution.without_effect.push_back(!curvature.acts(column));
  }
  solution.correlations.assign(free, std::vector<double>(free, 0.0));
  for (std::size_t i = 0; i < free; ++i)
    for (std::size_t j = 0; j < free; ++j) {
      const auto a = static_cast<Eigen::Index>(i), b = static_cast<Eigen::Index>(j);
      const double scale = std::sqrt(covariance(a, a) * covariance(b, b));
      solution.correlations[i][j] = i == j ? 1 : scale > 0 ? covariance(a, b) / scale : 0;
    }
  for (std::size_t p = 0; p < n; ++p) {
    const auto& s = samples[p];
    Own own = own_of(workshop, s, state, p);
    own.contact_error_m = curvature.deviation(covariance, static_cast<Eigen::Index>(free + p)) * s.radius_m;
    solution.own.push_back(std::move(own));
  }
  solution.samples = std::move(samples), solution.state = std::move(state);
  return solution;
}

} // namespace platen::calibrate
