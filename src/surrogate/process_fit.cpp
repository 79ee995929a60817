#include "core/interrupt.hpp"
#include "surrogate/kernel.hpp"

#include <ceres/gradient_problem.h>
#include <ceres/gradient_problem_solver.h>

#include <algorithm>
#include <cmath>

namespace platen::surrogate {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

constexpr std::size_t most_for_lengths = 300; ///< inputs: the cost grows with the cube

/// Where the prior of ln w, ln b and ln n is centred, and how wide it is: lengths of one and a half times the
/// range within a factor of four or so, slopes as large as the values, a nugget of a thousandth of the
/// deviation.
struct Prior {
  double centre, width;
};
constexpr Prior of_w{-0.4, 1.4}, of_plane{0, 2}, of_nugget{-13, 3};

/// -2 ln of the posterior density over (ln w..., ln b, ln n), v at its best.
class Objective final : public ceres::FirstOrderFunction {
 public:
  Objective(const Inputs& inputs, std::span<const double> values)
      : inputs_(inputs),
        y_(Eigen::Map<const VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()))) {}

  int NumParameters() const override { return static_cast<int>(inputs_.dimensions) + 2; }

  static Process at(const double* theta, std::size_t dimensions) {
    Process p;
    for (std::size_t k = 0; k < dimensions; ++k) p.w.push_back(std::exp(theta[k]));
    p.plane = std::exp(theta[dimensions]);
    p.nugget = std::exp(theta[dimensions + 1]) + least_nugget;
    return p;
  }

  bool Evaluate(const double* theta, double* cost, double* gradient) const override {
    const std::size_t d = inputs_.dimensions;
    for (std::size_t k = 0; k < d + 2; ++k)
      if (!(std::abs(theta[k]) < 40)) return false;
    const Process p = at(theta, d);
    const MatrixXd R = matrix_of(p, inputs_);
    const Eigen::LLT<MatrixXd> factor(R);
    if (factor.info() != Eigen::Success) return false;
    const VectorXd z = factor.solve(y_);
    const auto n = R.rows();
    const double v = y_.dot(z) / static_cast<double>(n);
    if (!(v > 0)) return false;
    const auto lower = factor.matrixLLT().diagonal();
    *cost = static_cast<double>(n) * std::log(v) + 2 * lower.array().log().sum();
    for (std::size_t k = 0; k < d + 2; ++k)
      *cost += std::pow((theta[k] - prior(k).centre) / prior(k).width, 2);
    if (!gradient) return true;
    // d cost = sum_ij G_ij dR_ij
    const MatrixXd G = factor.solve(MatrixXd::Identity(n, n)) - z * z.transpose() / v;
    std::vector<double> slope(d + 2, 0);
    for (Eigen::Index i = 0; i < n; ++i) {
      slope[d + 1] += G(i, i) * (p.nugget - least_nugget);
      for (Eigen::Index j = 0; j <= i; ++j) {
        const auto x = inputs_.row(static_cast<std::size_t>(i)), y = inputs_.row(static_cast<std::size_t>(j));
        const double twice = (i == j ? 1 : 2) * G(i, j);
        slope[d] += twice * p.plane * plane_product(x, y);
        if (i == j) continue;
        const double s = twice * steepness(distance(p.w, x, y)) * (-5.0 / 3);
        for (std::size_t k = 0; k < d; ++k) slope[k] += s * std::pow(p.w[k] * (x[k] - y[k]), 2);
      }
    }
    for (std::size_t k = 0; k < d + 2; ++k)
      gradient[k] = slope[k] + 2 * (theta[k] - prior(k).centre) / std::pow(prior(k).width, 2);
    return true;
  }

 private:
  static constexpr double least_nugget = 1e-10; // the matrix stays positive definite in double precision
  Prior prior(std::size_t k) const {
    return k < inputs_.dimensions ? of_w : k == inputs_.dimensions ? of_plane : of_nugget;
  }

  const Inputs& inputs_;
  VectorXd y_;
};

/// Ends the search where the user asked to stop.
class Watch final : public ceres::IterationCallback {
 public:
  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    return core::interrupted() ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
  }
};

} // namespace

Process fit_process(const Inputs& inputs, std::span<const double> values) {
  const std::size_t d = inputs.dimensions;
  Inputs first = inputs;
  first.values.resize(std::min(inputs.size(), most_for_lengths) * d);
  std::vector<double> best;
  double least = INFINITY;
  // The likelihood can have several maxima: long and short lengths to begin with.
  for (const double start : {-1.2, 0.3}) {
    std::vector<double> theta(d, start);
    theta.push_back(of_plane.centre);
    theta.push_back(of_nugget.centre + 3);
    const ceres::GradientProblem problem(new Objective(first, values.first(first.size())));
    ceres::GradientProblemSolver::Options options;
    options.logging_type = ceres::SILENT;
    options.max_num_iterations = 120;
    options.function_tolerance = 1e-7;
    Watch watch;
    options.callbacks.push_back(&watch);
    ceres::GradientProblemSolver::Summary summary;
    ceres::Solve(options, problem, theta.data(), &summary);
    core::stop_if_asked();
    if (best.empty() || summary.final_cost < least) best = theta, least = summary.final_cost;
  }
  Process p = Objective::at(best.data(), d);
  pass_through(p, inputs, values);
  return p;
}

} // namespace platen::surrogate
