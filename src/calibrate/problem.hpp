#pragma once
// The least squares problem of a calibration for Ceres: theta of the law; of each particle its contact point
// over R, and the zero of its load cell and its drift over the largest force.

#include "calibrate/state.hpp"
#include "calibrate/workshop.hpp"

#include <Eigen/Core>
#include <ceres/problem.h>

#include <array>
#include <vector>

namespace platen::calibrate {

/// How much of the zero of the load cell is fitted: nothing, its value, its value and a drift.
std::size_t zero_parameters(const Samples&);

/// Near a bound by this share of the way between the two, a value is said to be on it.
constexpr double on_bound_share = 1e-3;
/// Ends of what is searched.
std::array<double, 2> bounds(const Task&, std::size_t k);

class Problem {
 public:
  /// `held`: these theta stay.
  Problem(Workshop&, const std::vector<Samples>&, State, const std::vector<int>& held = {});

  /// Throws core::Interrupted.
  State solve();
  /// d(residuals)/d(theta, contacts, zeros), dense.
  Eigen::MatrixXd jacobian();

 private:
  const std::vector<Samples>& samples_;
  State state_;
  ceres::Problem problem_;
};

} // namespace platen::calibrate
