#include "fit/solve.hpp"

#include <glog/logging.h>

namespace platen::fit {

ceres::Solver::Summary solve(ceres::Problem& problem, ceres::Solver::Options options) {
  // Ceres writes residuals that are no numbers to glog, whatever its own type of logging is.
  [[maybe_unused]] static const bool silent = (FLAGS_minloglevel = google::GLOG_FATAL, true);
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return summary;
}

} // namespace platen::fit
