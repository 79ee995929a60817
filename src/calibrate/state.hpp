#pragma once

#include <array>
#include <limits>
#include <vector>

namespace platen::calibrate {

/// Where a search stands.
struct State {
  std::vector<double> theta, contact;
  std::vector<std::array<double, 2>> zero; ///< of the load cell, and its drift
  double cost = std::numeric_limits<double>::infinity();
  bool converged = false;
};

} // namespace platen::calibrate
