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

/// How far it is: the share that is done of what is going on, and what that is. False stops it.
using Show = std::function<bool(double share, const std::string& what)>;

/// Writes the page and gives its papers. `say` is told what has to be read. InvalidInput for an unknown
/// paper, and for what the catalogue lacks; IoError; Interrupted.
std::vector<Paper> reproduce(const Request&, const Show&, const std::function<void(const std::string&)>& say);

/// A table: of each paper how many rows, and their verdicts.
std::string words_of(const std::vector<Paper>&);

} // namespace platen::reproduce
