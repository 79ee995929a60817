#include "surrogate/ripples.hpp"

#include <Eigen/Dense>

#include <cmath>

namespace platen::surrogate {

std::vector<double> without_ripples(std::span<const double> knots, std::span<const double> values) {
  // Of the powders' 600 elements against their 2,500: less leaves ripples, more takes bends of the curve.
  constexpr double stiffness = 3e-7;
  const auto n = static_cast<Eigen::Index>(knots.size());
  if (n < 3) return {values.begin(), values.end()};
  Eigen::VectorXd u(n), weight(n);
  for (Eigen::Index i = 0; i < n; ++i) u(i) = std::sqrt(knots[static_cast<std::size_t>(i)]);
  for (Eigen::Index i = 0; i < n; ++i)
    weight(i) = (u(std::min(i + 1, n - 1)) - u(std::max(i - 1, Eigen::Index{0}))) / 2;
  Eigen::MatrixXd A = weight.asDiagonal();
  for (Eigen::Index i = 1; i + 1 < n; ++i) {
    const double before = u(i) - u(i - 1), after = u(i + 1) - u(i), both = before + after;
    const Eigen::Vector3d second(2 / (before * both), -2 / (before * after), 2 / (after * both));
    A.block<3, 3>(i - 1, i - 1) += stiffness * weight(i) * second * second.transpose();
  }
  const Eigen::Map<const Eigen::VectorXd> y(values.data(), n);
  const Eigen::VectorXd smooth = A.ldlt().solve(weight.cwiseProduct(y));
  return {smooth.data(), smooth.data() + n};
}

} // namespace platen::surrogate
