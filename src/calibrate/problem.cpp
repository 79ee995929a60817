#include "calibrate/problem.hpp"

#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "fit/solve.hpp"

#include <algorithm>

namespace platen::calibrate {
namespace {

struct Residuals {
  Workshop* workshop;
  const Samples* s;
  std::size_t zeros;

  /// Forces of late: differences in the zero of the load cell leave the law as it is.
  struct Known {
    std::vector<double> at, force;
    bool is_law = false;
  };
  mutable std::array<Known, 8> known = {};
  mutable std::size_t next = 0;

  const Known& force_at(const double* theta, double contact) const {
    std::vector<double> at(theta, theta + workshop->task().free.size());
    at.push_back(contact);
    for (const auto& k : known)
      if (k.at == at) return k;
    Known& k = known[next++ % known.size()];
    k.at = std::move(at);
    k.is_law = workshop->predicted(*s, theta, contact, k.force);
    return k;
  }

  bool operator()(const double* const* blocks, double* residuals) const {
    const auto& [at, force, is_law] = force_at(blocks[0], s->contact_guess_m + blocks[1][0] * s->radius_m);
    if (!is_law) { // a step that is not taken
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

struct StopWhenInterrupted : ceres::IterationCallback {
  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    return core::interrupted() ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
  }
};

} // namespace

std::size_t zero_parameters(const Samples& s) {
  constexpr std::size_t least_apart = 8; // rows out of contact that show it
  if (s.apart_before >= least_apart && s.apart_after >= least_apart) return 2;
  return s.apart_before + s.apart_after >= least_apart ? 1 : 0;
}

std::array<double, 2> bounds(const Task& task, std::size_t k) {
  const Coordinates c{task};
  return {c.inside(k, task.free[k].low * c.unit(k)), c.inside(k, task.free[k].high * c.unit(k))};
}

Problem::Problem(Workshop& workshop, const std::vector<Samples>& samples, State state,
                 const std::vector<int>& held)
    : samples_(samples), state_(std::move(state)) {
  const Task& task = workshop.task();
  ceres::NumericDiffOptions numeric;
  numeric.relative_step_size = 1e-5; // the tables of a law are smooth to 1e-6 or so
  for (std::size_t p = 0; p < samples.size(); ++p) {
    const std::size_t zeros = zero_parameters(samples[p]);
    auto* cost = new ceres::DynamicNumericDiffCostFunction<Residuals, ceres::FORWARD>(
        new Residuals{&workshop, &samples[p], zeros, {}, 0}, ceres::TAKE_OWNERSHIP, numeric);
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
    const auto [low, high] = bounds(task, k);
    // Inside by so much that a difference taken at the bound is not cut to nothing, which would hold it
    // there.
    const double margin = on_bound_share * (high - low);
    state_.theta[k] = std::clamp(state_.theta[k], low + margin, high - margin);
    problem_.SetParameterLowerBound(state_.theta.data(), static_cast<int>(k), low + margin);
    problem_.SetParameterUpperBound(state_.theta.data(), static_cast<int>(k), high - margin);
  }
  if (held.size() == task.free.size()) problem_.SetParameterBlockConstant(state_.theta.data());
  else if (!held.empty())
    problem_.SetManifold(state_.theta.data(),
                         new ceres::SubsetManifold(static_cast<int>(task.free.size()), held));
}

State Problem::solve() {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_SCHUR; // contact point and zero are each particle's own
  options.max_num_iterations = 100;
  options.function_tolerance = 1e-9;
  options.parameter_tolerance = 1e-8;
  options.num_threads = 1;
  StopWhenInterrupted stop;
  options.callbacks.push_back(&stop);
  const auto summary = fit::solve(problem_, options);
  core::stop_if_asked();
  state_.cost = summary.IsSolutionUsable() ? summary.final_cost : std::numeric_limits<double>::infinity();
  state_.converged = summary.termination_type == ceres::CONVERGENCE;
  return state_;
}

Eigen::MatrixXd Problem::jacobian() {
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

} // namespace platen::calibrate
