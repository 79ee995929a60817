#include "calibrate/search.hpp"

#include "core/error.hpp"
#include "core/interrupt.hpp"

#include <Eigen/Dense>
#include <ceres/ceres.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>

namespace platen::calibrate {
namespace {

using Numbers = std::vector<double>;

/// What of the zero of the load cell is fitted: nothing, its value, its value and a drift.
constexpr std::size_t least_apart = 8; // rows out of contact that show it
std::size_t zero_parameters(const Samples& s) {
  if (s.apart_before >= least_apart && s.apart_after >= least_apart) return 2;
  return s.apart_before + s.apart_after >= least_apart ? 1 : 0;
}

/// theta of the law; contact point over R; zero of the load cell and its drift over the largest force.
struct Residuals {
  Workshop* workshop;
  const Samples* s;
  std::size_t zeros;

  bool operator()(const double* const* blocks, double* residuals) const {
    Numbers force;
    const double contact = s->contact_guess_m + blocks[1][0] * s->radius_m;
    if (!workshop->predicted(*s, blocks[0], contact, force)) { // a step that is not taken
      for (std::size_t i = 0; i < s->force_N.size(); ++i) residuals[i] = 1e3 * s->force_max_N / s->sigma_N[i];
      return true;
    }
    const double zero = zeros > 0 ? blocks[2][0] * s->force_max_N : 0;
    const double drift = zeros > 1 ? blocks[2][1] * s->force_max_N : 0;
    for (std::size_t i = 0; i < force.size(); ++i)
      residuals[i] = (s->force_N[i] - zero - drift * s->progress[i] - force[i]) / s->sigma_N[i];
    return true;
  }
};

/// The contact point moves the curve; the travel that was there at the start keeps it near.
constexpr double contact_reach = 0.5; // of R
constexpr double on_bound_share = 1e-3;

struct StopWhenInterrupted : ceres::IterationCallback {
  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    return core::interrupted() ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
  }
};

struct State {
  Numbers theta, contact;
  std::vector<std::array<double, 2>> zero; ///< of the load cell, and its drift
  double cost = std::numeric_limits<double>::infinity();
  bool converged = false;
};

class Problem {
 public:
  Problem(Workshop& workshop, const std::vector<Samples>& samples, State state)
      : samples_(samples), state_(std::move(state)) {
    const Task& task = workshop.task();
    const Coordinates c{task};
    ceres::NumericDiffOptions numeric;
    numeric.relative_step_size = 1e-5; // the tables of a law are smooth to 1e-6 or so
    for (std::size_t p = 0; p < samples.size(); ++p) {
      const std::size_t zeros = zero_parameters(samples[p]);
      auto* cost = new ceres::DynamicNumericDiffCostFunction<Residuals, ceres::FORWARD>(
          new Residuals{&workshop, &samples[p], zeros}, ceres::TAKE_OWNERSHIP, numeric);
      std::vector<double*> blocks = {state_.theta.data(), &state_.contact[p]};
      cost->AddParameterBlock(static_cast<int>(task.free.size()));
      cost->AddParameterBlock(1);
      if (zeros > 0) {
        cost->AddParameterBlock(static_cast<int>(zeros));
        blocks.push_back(state_.zero[p].data());
      }
      cost->SetNumResiduals(static_cast<int>(samples[p].force_N.size()));
      problem_.AddResidualBlock(cost, nullptr, blocks);
      problem_.SetParameterLowerBound(&state_.contact[p], 0, -contact_reach);
      problem_.SetParameterUpperBound(&state_.contact[p], 0, contact_reach);
    }
    for (std::size_t k = 0; k < task.free.size(); ++k) {
      const double low = c.inside(k, task.free[k].low * c.unit(k)),
                   high = c.inside(k, task.free[k].high * c.unit(k));
      // Inside by so much that a difference taken at the bound is not cut to nothing, which would hold it
      // there.
      const double margin = on_bound_share * (high - low);
      problem_.SetParameterLowerBound(state_.theta.data(), static_cast<int>(k), low + margin);
      problem_.SetParameterUpperBound(state_.theta.data(), static_cast<int>(k), high - margin);
      state_.theta[k] = std::clamp(state_.theta[k], low + margin, high - margin);
    }
  }

  State solve() {
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_SCHUR; // contact point and zero are each particle's own
    options.max_num_iterations = 100;
    options.function_tolerance = 1e-9;
    options.parameter_tolerance = 1e-8;
    options.logging_type = ceres::SILENT;
    options.num_threads = 1;
    StopWhenInterrupted stop;
    options.callbacks.push_back(&stop);
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem_, &summary);
    if (core::interrupted()) throw core::Interrupted("stopped; nothing was written");
    state_.cost = summary.IsSolutionUsable() ? summary.final_cost : std::numeric_limits<double>::infinity();
    state_.converged = summary.termination_type == ceres::CONVERGENCE;
    return state_;
  }

  /// d(residuals)/d(theta, contacts, zeros), dense.
  Eigen::MatrixXd jacobian() {
    ceres::Problem::EvaluateOptions options;
    options.parameter_blocks.push_back(state_.theta.data());
    for (std::size_t p = 0; p < samples_.size(); ++p) options.parameter_blocks.push_back(&state_.contact[p]);
    for (std::size_t p = 0; p < samples_.size(); ++p)
      if (zero_parameters(samples_[p]) > 0) options.parameter_blocks.push_back(state_.zero[p].data());
    ceres::CRSMatrix sparse;
    problem_.Evaluate(options, nullptr, nullptr, nullptr, &sparse);
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(sparse.num_rows, sparse.num_cols);
    for (int row = 0; row < sparse.num_rows; ++row)
      for (int k = sparse.rows[static_cast<std::size_t>(row)];
           k < sparse.rows[static_cast<std::size_t>(row) + 1]; ++k)
        J(row, sparse.cols[static_cast<std::size_t>(k)]) = sparse.values[static_cast<std::size_t>(k)];
    return J;
  }

 private:
  const std::vector<Samples>& samples_;
  State state_;
  ceres::Problem problem_;
};

/// Every combination of starts, cheapest deviations first.
std::vector<Numbers> starts(Workshop& workshop, const Samples& s) {
  const Task& task = workshop.task();
  const Coordinates c{task};
  std::vector<Numbers> grid = {{}};
  for (std::size_t k = 0; k < task.free.size(); ++k) {
    std::vector<Numbers> longer;
    for (const auto& begun : grid)
      for (double start : task.free[k].starts) {
        longer.push_back(begun);
        longer.back().push_back(c.inside(k, start * c.unit(k)));
      }
    grid = std::move(longer);
  }
  std::vector<std::pair<double, std::size_t>> order;
  Numbers force;
  for (std::size_t g = 0; g < grid.size(); ++g) {
    if (!workshop.predicted(s, grid[g].data(), s.contact_guess_m, force)) continue;
    double sum = 0;
    for (std::size_t i = 0; i < force.size(); ++i)
      sum += std::pow((s.force_N[i] - force[i]) / s.sigma_N[i], 2);
    order.emplace_back(sum, g);
  }
  std::ranges::sort(order);
  std::vector<Numbers> best;
  constexpr std::size_t tried = 3;
  for (const auto& [sum, g] : order)
    if (best.size() < tried) best.push_back(grid[g]);
  if (best.empty())
    throw core::InvalidInput("the law has no material near these readings; are force, displacement and "
                             "radius in the right units?");
  return best;
}

/// From the stiffness of a first fit.
void weigh(Workshop& workshop, std::vector<Samples>& samples, const State& state) {
  Numbers force, stiffness;
  for (std::size_t p = 0; p < samples.size(); ++p) {
    auto& s = samples[p];
    const double contact = s.contact_guess_m + state.contact[p] * s.radius_m;
    if (!workshop.predicted(s, state.theta.data(), contact, force, &stiffness)) continue;
    const double floor = std::max(s.force_noise_N, 1e-4 * s.force_max_N);
    for (std::size_t i = 0; i < force.size(); ++i) {
      const double k = s.per_travel * stiffness[i];
      s.sigma_N[i] = std::hypot(floor, k * s.travel_noise_m / (1 + k * s.compliance[i]));
    }
  }
}

/// Which rows are out of contact a first fit tells: those where the law has no force.
void find_apart(Workshop& workshop, std::vector<Samples>& samples, const State& state) {
  Numbers force;
  for (std::size_t p = 0; p < samples.size(); ++p) {
    auto& s = samples[p];
    if (!workshop.predicted(s, state.theta.data(), s.contact_guess_m + state.contact[p] * s.radius_m, force))
      continue;
    // Not where the machine does measure force: a poor first fit may think so.
    const auto apart = [&](std::size_t i) { return !(force[i] > 0) && s.force_N[i] < 0.1 * s.force_max_N; };
    s.apart_before = s.apart_after = 0;
    while (s.apart_before < force.size() && apart(s.apart_before)) ++s.apart_before;
    while (s.apart_after + s.apart_before < force.size() && apart(force.size() - 1 - s.apart_after))
      ++s.apart_after;
  }
}

/// Particles of one batch fit the law more or less well; each counts by how well it does.
void level(Workshop& workshop, std::vector<Samples>& samples, const State& state) {
  for (std::size_t p = 0; p < samples.size(); ++p) {
    auto& s = samples[p];
    Numbers force;
    if (!workshop.predicted(s, state.theta.data(), s.contact_guess_m + state.contact[p] * s.radius_m, force))
      continue;
    double sum = 0;
    for (std::size_t i = 0; i < force.size(); ++i)
      sum += std::pow(
          (s.force_N[i] - (state.zero[p][0] + state.zero[p][1] * s.progress[i]) * s.force_max_N - force[i]) /
              s.sigma_N[i],
          2);
    const double rms = std::sqrt(sum / static_cast<double>(force.size()));
    for (double& sigma : s.sigma_N) sigma *= std::max(rms, 1e-6);
  }
}

} // namespace

Solution search(const Task& task, std::vector<Samples> samples, const Numbers& given_start) {
  const std::size_t n = samples.size(), free = task.free.size();
  const Coordinates c{task};
  Workshop workshop(task);
  State state;
  const auto try_from = [&](const std::vector<Numbers>& begins) {
    for (const auto& begin : begins) {
      State found =
          Problem(workshop, samples, {begin, Numbers(n, 0.0), std::vector<std::array<double, 2>>(n, {0, 0})})
              .solve();
      if (found.cost < state.cost) state = std::move(found);
    }
  };
  std::size_t rows = 0;
  for (const auto& s : samples) rows += s.force_N.size();
  if (!given_start.empty()) {
    Numbers begin;
    for (std::size_t k = 0; k < free; ++k) begin.push_back(c.inside(k, given_start[k]));
    try_from({begin});
  }
  // A start that was given may lead into a minimum of its own: more than the noise is left then.
  constexpr double much = 1.5;
  if (given_start.empty() || !(2 * state.cost < much * static_cast<double>(rows)))
    try_from(starts(workshop, samples.front()));
  if (state.theta.empty())
    throw core::ConvergenceError("the law could not be fitted to these rows", 0, 100, 1);
  for (int again = 0; again < 2; ++again) {
    weigh(workshop, samples, state);
    find_apart(workshop, samples, state);
    if (n > 1) level(workshop, samples, state);
    state = Problem(workshop, samples, state).solve();
  }
  if (!std::isfinite(state.cost))
    throw core::ConvergenceError("the law could not be fitted to these rows", 0, 100, 1);

  Solution solution;
  solution.converged = state.converged;
  for (std::size_t p = 0; p < n; ++p) { // what was fitted once and is not shown after all
    if (zero_parameters(samples[p]) < 2) state.zero[p][1] = 0;
    if (zero_parameters(samples[p]) < 1) state.zero[p][0] = 0;
  }
  Problem problem(workshop, samples, state);
  const Eigen::MatrixXd J = problem.jacobian();
  solution.reduced_chi_squared = 2 * state.cost / std::max(1.0, static_cast<double>(J.rows() - J.cols()));
  // Columns in units of their own length: what has no effect is left out of the inversion.
  Eigen::VectorXd length = J.colwise().norm();
  const double longest = length.maxCoeff();
  Eigen::MatrixXd scaled = J;
  for (Eigen::Index k = 0; k < J.cols(); ++k)
    scaled.col(k) /= length[k] > 1e-9 * longest ? length[k] : std::numeric_limits<double>::infinity();
  const Eigen::MatrixXd covariance =
      (scaled.transpose() * scaled).completeOrthogonalDecomposition().pseudoInverse() *
      solution.reduced_chi_squared;
  const auto sd = [&](Eigen::Index k) {
    return length[k] > 1e-9 * longest ? std::sqrt(std::max(0.0, covariance(k, k))) / length[k]
                                      : std::numeric_limits<double>::infinity();
  };
  for (std::size_t k = 0; k < free; ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    const double theta = state.theta[k];
    solution.values.push_back(c.outside(k, theta));
    solution.errors.push_back(sd(column) * c.slope(k, theta));
    const double low = c.inside(k, task.free[k].low * c.unit(k)),
                 high = c.inside(k, task.free[k].high * c.unit(k));
    const double near = on_bound_share * (high - low);
    // The law may end before the bound, as agarwal does where E is little above the strength.
    bool ends = false;
    for (const double step : {-near, near}) {
      auto beside = state.theta;
      beside[k] += step;
      ends = ends || !workshop.law(beside.data(), workshop.made_for(samples.front()));
    }
    if (ends) solution.errors.back() = std::numeric_limits<double>::infinity();
    solution.on_bound.push_back(ends || theta < low + 1.5 * near || theta > high - 1.5 * near);
    solution.without_effect.push_back(!(length[column] > 1e-9 * longest));
  }
  solution.correlations.assign(free, Numbers(free, 0.0));
  for (std::size_t i = 0; i < free; ++i)
    for (std::size_t j = 0; j < free; ++j) {
      const auto a = static_cast<Eigen::Index>(i), b = static_cast<Eigen::Index>(j);
      const double scale = std::sqrt(covariance(a, a) * covariance(b, b));
      solution.correlations[i][j] = i == j ? 1 : scale > 0 ? covariance(a, b) / scale : 0;
    }
  for (std::size_t p = 0; p < n; ++p) {
    const auto& s = samples[p];
    Own own;
    own.contact_m = s.contact_guess_m + state.contact[p] * s.radius_m;
    own.contact_error_m = sd(static_cast<Eigen::Index>(free + p)) * s.radius_m;
    own.baseline_fitted = zero_parameters(s) > 0, own.drift_fitted = zero_parameters(s) > 1;
    own.baseline_N = state.zero[p][0] * s.force_max_N, own.drift_N = state.zero[p][1] * s.force_max_N;
    workshop.predicted(s, state.theta.data(), own.contact_m, own.force_N);
    solution.own.push_back(std::move(own));
  }
  return solution;
}

} // namespace platen::calibrate
