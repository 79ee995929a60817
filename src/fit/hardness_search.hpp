#pragma once
// Least squares of ln H_bar and ln F_bar together over the rows of a curve, for the coefficients of a law's
// hardness, with the contact radius fitted before: what the radius's form cannot follow is shared between
// hardness and force. Included by the fits alone: it brings Ceres with it.

#include "fit/large_deformation.hpp"
#include "fit/solve.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

namespace platen::fit {

struct SearchRange {
  std::string_view key;
  double start, low, high;
  bool held;
};

/// Keys of what was found where the search ends, and may lie beyond.
inline std::vector<std::string_view> on_bounds(const std::vector<double>& theta,
                                               const std::vector<SearchRange>& ranges) {
  std::vector<std::string_view> keys;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const auto& range = ranges[i];
    const double near = 1e-4 * (range.high - range.low);
    if (!range.held &&
        (theta[i] < range.low + std::min(near, 1e-3 * range.low) || theta[i] > range.high - near))
      keys.push_back(range.key);
  }
  return keys;
}

template <class Law> struct LogHardnessAndForce {
  const Law& law;
  const std::vector<LoadedRow>& rows;
  law::RadiusPolynomial<double> radius;
  template <class Real> bool operator()(const Real* theta, Real* residual) const {
    const auto curve = law(theta);
    using std::log;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Real H = curve.at(Real(rows[i].x)).H;
      if (!(Real(0) < H)) return false;
      const double a = radius.a_bar(rows[i].x);
      residual[2 * i] = log(H / Real(rows[i].point.H));
      residual[2 * i + 1] = log(H * Real(a * a / rows[i].point.F));
    }
    return true;
  }
};

/// `law(theta)` gives the curve whose at(x).H is used, for double and for Ceres' dual numbers.
template <class Law>
std::vector<double> search_hardness(const Law& law, const std::vector<LoadedRow>& rows,
                                    const law::RadiusPolynomial<double>& radius,
                                    const std::vector<SearchRange>& ranges) {
  constexpr int n = Law::coefficients;
  std::vector<double> theta;
  std::vector<int> held;
  ceres::Problem problem;
  for (const auto& range : ranges)
    theta.push_back(range.held ? range.start : std::clamp(range.start, range.low, range.high));
  problem.AddResidualBlock(
      new ceres::AutoDiffCostFunction<LogHardnessAndForce<Law>, ceres::DYNAMIC, n>(
          new LogHardnessAndForce<Law>{law, rows, radius}, 2 * static_cast<int>(rows.size())),
      nullptr, theta.data());
  for (int i = 0; i < n; ++i) {
    const auto& range = ranges[static_cast<std::size_t>(i)];
    if (range.held) {
      held.push_back(i);
      continue;
    }
    problem.SetParameterLowerBound(theta.data(), i, range.low);
    problem.SetParameterUpperBound(theta.data(), i, range.high);
  }
  if (held.size() == ranges.size()) return theta;
  if (!held.empty()) problem.SetManifold(theta.data(), new ceres::SubsetManifold(n, held));
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = 200;
  solve(problem, options);
  return theta;
}

} // namespace platen::fit
