#include "surrogate/components.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace platen::surrogate {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

constexpr double negligible = 5e-4; ///< of a logarithm: what the components may leave out, root mean square
constexpr std::size_t most_components = 10;

} // namespace

Reduced reduce(const Table& table) {
  if (table[0].empty()) return {};
  const auto n = static_cast<Eigen::Index>(table.size()), m = static_cast<Eigen::Index>(table[0].size());
  MatrixXd Y(n, m);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < m; ++j)
      Y(i, j) = table[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  const VectorXd mean = Y.colwise().mean();
  Y.rowwise() -= mean.transpose();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> ascending(Y.transpose() * Y);
  Reduced reduced;
  reduced.components.mean.assign(mean.data(), mean.data() + m);
  MatrixXd rest = Y;
  const auto rms = [&] { return std::sqrt(rest.squaredNorm() / static_cast<double>(n * m)); };
  for (Eigen::Index c = 0;
       c < std::min(n, m) && reduced.scores.size() < most_components && rms() > negligible; ++c) {
    VectorXd direction = ascending.eigenvectors().col(m - 1 - c);
    if (direction.sum() < 0) direction = -direction; // signs are the decomposition's whim
    const VectorXd score = Y * direction;
    rest -= score * direction.transpose();
    reduced.components.basis.emplace_back(direction.data(), direction.data() + m);
    reduced.scores.emplace_back(score.data(), score.data() + n);
  }
  for (Eigen::Index j = 0; j < m; ++j)
    reduced.components.rest.push_back(std::sqrt(rest.col(j).squaredNorm() / static_cast<double>(n)));
  return reduced;
}

Crossed cross(const Components& components, const Table& table, const Inputs& inputs) {
  const std::size_t n = inputs.size(), m = components.mean.size();
  Crossed crossed{Table(n, components.mean), Table(n, std::vector<double>(m))};
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j) crossed.variance[i][j] = components.rest[j] * components.rest[j];
  for (std::size_t c = 0; c < components.basis.size(); ++c) {
    const auto& basis = components.basis[c];
    std::vector<double> scores(n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < m; ++j) scores[i] += basis[j] * (table[i][j] - components.mean[j]);
    const auto out = left_out(components.processes[c], inputs, scores);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < m; ++j) {
        crossed.mean[i][j] += basis[j] * out.mean[i];
        crossed.variance[i][j] += basis[j] * basis[j] * out.variance[i];
      }
  }
  return crossed;
}

std::vector<double> values_at(const Components& components, const Columns& inputs,
                              std::span<const double> at) {
  auto values = components.mean;
  const auto scores = means(components.processes, inputs, at);
  for (std::size_t c = 0; c < components.basis.size(); ++c)
    for (std::size_t j = 0; j < values.size(); ++j) values[j] += scores[c] * components.basis[c][j];
  return values;
}

std::vector<double> variances_at(const Components& components, const Columns& inputs,
                                 std::span<const double> at) {
  std::vector<double> variance;
  for (const double rest : components.rest) variance.push_back(rest * rest);
  const auto of_scores = variances(components.processes, inputs, at);
  for (std::size_t c = 0; c < components.basis.size(); ++c) {
    const Process& process = components.processes[c];
    const double of_score = of_scores[c] + process.nugget * process.variance;
    for (std::size_t j = 0; j < variance.size(); ++j)
      variance[j] += of_score * components.basis[c][j] * components.basis[c][j];
  }
  return variance;
}

} // namespace platen::surrogate
