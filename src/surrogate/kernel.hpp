#pragma once
// The kernel of a process (process.hpp) and its matrix: what is asked of it, and what its fit differentiates.

#include "surrogate/process.hpp"

#include <Eigen/Dense>

#include <cmath>

namespace platen::surrogate {

inline double correlation(double r) { return (1 + r + r * r / 3) * std::exp(-r); }
/// Its derivative over r^2, times -6.
inline double steepness(double r) { return (1 + r) * std::exp(-r); }

inline double distance(std::span<const double> w, std::span<const double> x, std::span<const double> y) {
  double squares = 0;
  for (std::size_t k = 0; k < w.size(); ++k) squares += std::pow(w[k] * (x[k] - y[k]), 2);
  return std::sqrt(5 * squares);
}

inline double plane_product(std::span<const double> x, std::span<const double> y) {
  double sum = 1;
  for (std::size_t k = 0; k < x.size(); ++k) sum += (x[k] - 0.5) * (y[k] - 0.5);
  return sum;
}

inline double covariance(const Process& p, std::span<const double> x, std::span<const double> y) {
  return p.variance * (correlation(distance(p.w, x, y)) + p.plane * plane_product(x, y));
}

/// The matrix over v.
inline Eigen::MatrixXd matrix_of(const Process& p, const Inputs& inputs) {
  const auto n = static_cast<Eigen::Index>(inputs.size());
  Process unit = p;
  unit.variance = 1;
  Eigen::MatrixXd R(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j <= i; ++j)
      R(i, j) = R(j, i) =
          covariance(unit, inputs.row(static_cast<std::size_t>(i)), inputs.row(static_cast<std::size_t>(j)));
    R(i, i) += p.nugget;
  }
  return R;
}

} // namespace platen::surrogate
