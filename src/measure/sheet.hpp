#pragma once
// The tables of a text: where they begin, what heads their columns, and what stands between them.

#include "measure/dialect.hpp"
#include "measure/quantity.hpp"
#include "measure/text.hpp"

#include <string>
#include <utility>
#include <vector>

namespace platen::measure {

struct Column {
  Heading heading;
  std::vector<double> values; ///< NaN where there is no number
  /// Cells that are no number, by row; empty ones not. At most `kept` of a column that is not asked for.
  std::vector<std::pair<std::size_t, std::string>> words;
  static constexpr std::size_t kept = 1000000;
};

/// A line of text, as cells.
struct Remark {
  int line = 0;
  std::vector<std::string> cells;

  std::string text() const; ///< the cells with blanks between
};

struct Table {
  int line = 0; ///< of its header
  std::vector<Column> columns;
  std::vector<int> lines;          ///< of its rows
  std::vector<std::string> titles; ///< over the columns, where a row of them stands above the header
  std::vector<Remark> remarks;     ///< since the table before
};

struct Sheet {
  std::string file, encoding;
  Dialect dialect;
  std::vector<Table> tables;
  std::vector<std::string> said; ///< what was left out, a sentence each
};

/// InvalidInput where there are no rows of numbers, no header above them, or a row that is no row of the
/// table.
Sheet read_sheet(const Text&);

} // namespace platen::measure
