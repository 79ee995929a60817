#pragma once
// The papers beside what we say, from their names to the page.

#include "reproduce/page.hpp"
#include "reproduce/papers.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace platen::reproduce {

struct Request {
  std::string paper;            ///< of paper_names(), or "all"
  std::filesystem::path folder; ///< of the page
  bool fresh = false;           ///< press everything again, hours, resumed where it stopped
  int workers = 1;              ///< processes that press then
  std::filesystem::path
      previous; ///< numbers.csv of an earlier page; empty: the one in the folder, else the catalogue's
};

/// How far it is: what is going on ("pool wang"), the share of it that is done, and where it is ("3 of 162
/// runs"). False stops it.
using Show = std::function<bool(const std::string& stage, double share, const std::string& note)>;

/// Writes the page and gives its papers. `say` is told what has to be read. InvalidInput for an unknown
/// paper, and for what the catalogue lacks; IoError; Interrupted.
std::vector<Paper> reproduce(const Request&, const Show&, const std::function<void(const std::string&)>& say);

/// A table: of each paper how many rows, and their verdicts.
std::string words_of(const std::vector<Paper>&);

} // namespace platen::reproduce
