#pragma once

#include <vector>

namespace platen::fit {

/// The coefficients c with the least |sum of c_k columns_k - y|; columns as long as y, and not fewer rows
/// than columns.
std::vector<double> least_squares(const std::vector<std::vector<double>>& columns,
                                  const std::vector<double>& y);

} // namespace platen::fit
