#pragma once
// numbers.csv: every comparison of a page, so that a later page can say what has changed.

#include "reproduce/papers.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace platen::reproduce {

/// What an earlier page said.
struct Earlier {
  std::string engine, version;
  struct Number {
    double ours = 0, difference = 0;
    std::string verdict; ///< of its row
  };
  std::map<std::string, Number> numbers; ///< by "row/place"
};

/// paper,row,place,what,theirs,ours,difference,tolerance,measure,error,verdict
std::string numbers_csv(const std::vector<Paper>&);

Earlier read_numbers(const std::filesystem::path&);

/// A comparison that moved by more than its error.
struct Change {
  std::string row, name; ///< id and "Fig. 11"
  std::string what;
  double before = 0, now = 0; ///< differences from the paper
  Measure measure = Measure::relative;
  std::string verdict_before, verdict_now;
};

/// Comparisons that both pages have, whose difference from the paper moved by more than the error of ours, or
/// whose row has another verdict.
std::vector<Change> changes(const std::vector<Paper>&, const Earlier&);

} // namespace platen::reproduce
