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
  for (std::size_t k = 0; k < w.size(); ++k) squares += w[k] * (x[k] - y[k]) * w[k] * (x[k] - y[k]);
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

using Rows = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;
inline Rows rows_of(const Inputs& inputs) {
  return {inputs.values.data(), static_cast<Eigen::Index>(inputs.size()),
          static_cast<Eigen::Index>(inputs.dimensions)};
}
inline Eigen::Map<const Eigen::VectorXd> vector_of(std::span<const double> x) {
  return {x.data(), static_cast<Eigen::Index>(x.size())};
}

/// The matrix over v, a column at a time, its kernels together.
inline Eigen::MatrixXd matrix_of(const Process& p, const Inputs& inputs) {
  const auto x = rows_of(inputs);
  const Eigen::Index n = x.rows(), d = x.cols();
  const Eigen::MatrixXd centred = (x.array() - 0.5).matrix(),
                        scaled = x * (std::sqrt(5.0) * vector_of(p.w)).asDiagonal();
  Eigen::MatrixXd R = Eigen::MatrixXd::Constant(n, n, p.plane);
  R.selfadjointView<Eigen::Lower>().rankUpdate(centred, p.plane);
  Eigen::ArrayXd r(n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Eigen::Index rest = n - j;
    auto here = r.tail(rest);
    here.setZero();
    for (Eigen::Index k = 0; k < d; ++k) here += (scaled.col(k).tail(rest).array() - scaled(j, k)).square();
    here = here.sqrt();
    R.col(j).tail(rest).array() += (1 + here + here.square() / 3) * (-here).exp();
    R(j, j) += p.nugget;
  }
  R.triangularView<Eigen::StrictlyUpper>() = R.transpose();
  return R;
}

} // namespace platen::surrogate
