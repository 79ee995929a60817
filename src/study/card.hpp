#pragma once
// Study cards (TOML): many cases that differ in named factors, and the laws fitted to their curves.

#include "press/case.hpp"
#include "study/design.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace platen::study {

struct Run {
  Point inputs; ///< the level of each factor
  press::Case press_case;
  double stop_at = 0; ///< delta/R0 behind which the press stops, unfinished; 0: nowhere
};

struct Study {
  std::string file, name;
  std::string kind; ///< of the design: factorial, latin-hypercube, space-filling, table
  int seed = 1;
  std::vector<Factor> factors;
  std::vector<std::string> laws; ///< of [fit]
  std::vector<Run> runs;         ///< every case validated
};

/// A study card by path. The base case is a path beside the card, or a table. InvalidInput for unknown keys,
/// unknown factors, empty designs, and for the first run that is no admissible case.
Study read_study(std::string_view path);

/// The points of its design.
std::vector<Point> points_of(const Study&);

/// The reference page of study cards, as Markdown.
std::string study_reference();

} // namespace platen::study
