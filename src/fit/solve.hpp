#pragma once
// Ceres' solver without its voice. Included by the fits alone: it brings Ceres with it.

#include <ceres/ceres.h>

namespace platen::fit {

/// Prints nothing: where there is no solution, the summary says so.
ceres::Solver::Summary solve(ceres::Problem&, ceres::Solver::Options);

} // namespace platen::fit
