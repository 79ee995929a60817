#pragma once
// The page: index.html with figures/ and numbers.csv beside it. Static, asks nothing of any server.

#include "reproduce/numbers.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace platen::reproduce {

struct Tally {
  std::size_t rows = 0, reproduced = 0, differing = 0, not_comparable = 0;
  std::size_t with_number = 0; ///< rows that set a number of the paper against ours
};
Tally tally(const std::vector<Row>&);

/// Draws the charts into DIR/figures, copies pictures there, and writes index.html and numbers.csv. `show` is
/// told the share that is done. `earlier`: the numbers of a page before, and the words for where they are
/// from.
void write_page(const std::vector<Paper>&, const Data&, const std::optional<Earlier>& earlier,
                const std::filesystem::path& folder, const std::function<void(double)>& show);

} // namespace platen::reproduce
