#pragma once
// Many numbers that go together, as a few principal components, each a Gaussian process over the coordinates.

#include "surrogate/process.hpp"

#include <span>
#include <vector>

namespace platen::surrogate {

/// Rows: runs.
using Table = std::vector<std::vector<double>>;

/// Values that go together, as mean + sum_c (score_c) basis_c.
struct Components {
  std::vector<double> mean;
  std::vector<std::vector<double>> basis;
  std::vector<double> rest; ///< standard deviation of what the components leave out
  std::vector<Process> processes;
};

/// Scores of each run (components x runs).
struct Reduced {
  Components components;
  Table scores;
};

/// Components without processes; none of an empty table.
Reduced reduce(const Table& table);

/// What the components say of each run when it is left out (runs x values), and the variance of that.
struct Crossed {
  Table mean, variance;
};

Crossed cross(const Components& components, const Table& table, const Inputs& inputs);

/// The values at a place.
std::vector<double> values_at(const Components& components, const Columns& inputs,
                              std::span<const double> at);

/// Their variances, with the nugget: of a press, not of the mean of many.
std::vector<double> variances_at(const Components& components, const Columns& inputs,
                                 std::span<const double> at);

} // namespace platen::surrogate
