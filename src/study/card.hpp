#pragma once
// Study cards (TOML): many cases that differ in named factors, and the laws fitted to their curves.

#include "press/case.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace platen::study {

struct Run {
  std::vector<double> inputs; ///< the value of each factor
  press::Case press_case;
};

struct Study {
  std::string file, name;
  std::vector<std::string> factors; ///< "material.E_bar", "path.delta_bar_max", "radius_m"
  std::vector<std::string> laws;    ///< of [fit]
  std::vector<Run> runs;            ///< every case validated
};

/// A study card by path. The base case is a path beside the card, or a table. InvalidInput for unknown keys,
/// unknown factors, empty designs, and for the first run that is no admissible case.
Study read_study(std::string_view path);

} // namespace platen::study
