#include "surrogate/refine.hpp"

#include "core/interrupt.hpp"
#include "surrogate/kernel.hpp"
#include "surrogate/said.hpp"

#include <algorithm>

namespace platen::surrogate {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

/// What one process knows of the candidates: the covariance between two of them is what the kernel says less
/// the product of their columns.
struct OfCandidates {
  const Process& process;
  const std::vector<double>& basis;
  MatrixXd known; ///< a row for each press, those to come as well
  VectorXd variance;
  Eigen::Index rows;
};

} // namespace

Refined refine(const Surrogate& s, const std::vector<Description>& candidates, double target,
               std::size_t most) {
  const auto count = static_cast<Eigen::Index>(candidates.size());
  std::vector<std::vector<double>> at, F, others; // others: variances that presses of the finest mesh leave
  std::vector<double> scatter2;                   // what stands before those of the finest layer
  const Layer& finest = s.layers.back();
  for (const auto& d : candidates) {
    const auto said = said_of(s, d, nullptr);
    at.push_back(input_of(s, d.coordinates));
    F.push_back(exponentials(said.F, 0, said.F.size()));
    others.push_back(said.F_variance);
    scatter2.push_back(said.scatter * said.scatter);
  }
  std::vector<OfCandidates> processes;
  for (std::size_t c = 0; c < finest.force.basis.size(); ++c) {
    const Process& p = finest.force.processes[c];
    const auto n = static_cast<Eigen::Index>(finest.inputs.size());
    MatrixXd between(n, count);
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j < count; ++j)
        between(i, j) =
            covariance(p, finest.inputs.row(static_cast<std::size_t>(i)), at[static_cast<std::size_t>(j)]);
    const MatrixXd K = matrix_of(p, finest.inputs) * p.variance;
    OfCandidates one{p, finest.force.basis[c], MatrixXd(n + static_cast<Eigen::Index>(most), count),
                     VectorXd(count), n};
    one.known.topRows(n) = K.llt().matrixL().solve(between);
    for (Eigen::Index j = 0; j < count; ++j) {
      const auto& x = at[static_cast<std::size_t>(j)];
      one.variance(j) = std::max(0.0, covariance(p, x, x) - one.known.col(j).head(n).squaredNorm());
      for (std::size_t k = 0; k < one.basis.size(); ++k) // variances_at() has it as well, or a little more
        others[static_cast<std::size_t>(j)][k] = std::max(
            0.0, others[static_cast<std::size_t>(j)][k] -
                     scatter2[static_cast<std::size_t>(j)] * one.variance(j) * one.basis[k] * one.basis[k]);
    }
    processes.push_back(std::move(one));
  }
  const auto expected = [&](std::size_t j) {
    auto variance = others[j];
    for (const auto& p : processes)
      for (std::size_t k = 0; k < variance.size(); ++k)
        variance[k] += scatter2[j] * p.variance(static_cast<Eigen::Index>(j)) * p.basis[k] * p.basis[k];
    return expected_errors(s.knots, F[j], variance).back();
  };
  Refined refined;
  for (;;) {
    core::stop_if_asked();
    std::size_t worst = 0;
    double largest = -1;
    for (std::size_t j = 0; j < candidates.size(); ++j) {
      if (std::find(refined.chosen.begin(), refined.chosen.end(), j) != refined.chosen.end()) continue;
      if (const double e = expected(j); e > largest) largest = e, worst = j;
    }
    refined.largest.push_back(std::max(largest, 0.0));
    if (largest <= target || refined.chosen.size() == most) return refined;
    const auto w = static_cast<Eigen::Index>(worst);
    for (auto& p : processes) {
      const double noise = p.process.nugget * p.process.variance, scale = std::sqrt(p.variance(w) + noise);
      for (Eigen::Index j = 0; j < count; ++j) {
        const double posterior = covariance(p.process, at[static_cast<std::size_t>(j)], at[worst]) -
                                 p.known.col(j).head(p.rows).dot(p.known.col(w).head(p.rows));
        p.known(p.rows, j) = scale > 0 ? posterior / scale : 0;
      }
      for (Eigen::Index j = 0; j < count; ++j)
        p.variance(j) = std::max(0.0, p.variance(j) - p.known(p.rows, j) * p.known(p.rows, j));
      ++p.rows;
    }
    refined.chosen.push_back(worst);
  }
}

} // namespace platen::surrogate
