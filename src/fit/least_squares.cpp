#include "fit/least_squares.hpp"

#include <Eigen/Dense>

#include <cstddef>

namespace platen::fit {

std::vector<double> least_squares(const std::vector<std::vector<double>>& columns,
                                  const std::vector<double>& y) {
  const auto rows = static_cast<Eigen::Index>(y.size());
  Eigen::MatrixXd A(rows, static_cast<Eigen::Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k)
    A.col(static_cast<Eigen::Index>(k)) = Eigen::Map<const Eigen::VectorXd>(columns[k].data(), rows);
  const Eigen::VectorXd c = A.colPivHouseholderQr().solve(Eigen::Map<const Eigen::VectorXd>(y.data(), rows));
  return {c.begin(), c.end()};
}

} // namespace platen::fit
