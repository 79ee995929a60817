#pragma once
// Factors: what differs between the cases of a study.

#include "core/toml.hpp"

#include <map>
#include <string>
#include <variant>
#include <vector>

namespace platen::study {

/// What a factor takes in one run: a number, or a word (an experiment, a material).
using Level = std::variant<double, std::string>;
std::string text_of(const Level&);

/// "material.E_bar", "path.delta_bar_max", "radius_m", and where its levels come from: a list, a range, or a
/// column of a table.
struct Factor {
  std::string name;
  std::vector<Level> values; ///< empty: a range, or a column
  double min = 0, max = 0;
  bool log = false;                         ///< the range is filled evenly in the logarithm
  std::string column;                       ///< of a table
  std::map<std::string, std::string> names; ///< words of the column → words of the factor
};

/// The base case of a study card, its material as a table, so that factors can reach into it.
core::Table base_case(const core::Table& study_card);

/// Gives a case card the level of a factor. "material.E_bar" is material.parameters.E_bar, and takes E_Pa
/// away, which names the same quantity; "material" is a whole material; others are [section].key of the case,
/// or a key at its top. InvalidInput where the name leads through something that is no table.
void set(core::Table& case_card, const std::string& factor, const Level&);

} // namespace platen::study
