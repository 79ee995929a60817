#include "measure/sheet.hpp"

#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "core/toml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace platen::measure {
namespace {

using core::InvalidInput;
using Cells = std::vector<std::string_view>;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

struct Census {
  std::size_t numbers = 0, words = 0, filled = 0;
};
Census census(const Cells& cells, const Dialect& dialect) {
  Census c;
  for (const auto cell : cells) {
    if (cell.empty()) continue;
    ++c.filled;
    if (number_in(cell, dialect)) ++c.numbers;
    else c.words += !is_no_reading(cell);
  }
  return c;
}

/// "(s)","(mm)","(N)" or "s","N","mm".
bool is_row_of_units(const Remark& remark) {
  std::size_t units = 0, filled = 0;
  for (const auto& cell : remark.cells) {
    if (cell.empty()) continue;
    ++filled;
    const bool bracketed =
        (cell.front() == '[' && cell.back() == ']') || (cell.front() == '(' && cell.back() == ')');
    units += bracketed || unit_named(cell) || cell == "%" || cell == "V" || cell == "°C" || cell == "-";
  }
  return filled > 0 && units == filled;
}

std::string without_brackets(std::string_view cell) {
  if (cell.size() > 1 && (cell.front() == '[' || cell.front() == '(')) cell = cell.substr(1, cell.size() - 2);
  return std::string(trimmed(cell));
}

class Reader {
 public:
  explicit Reader(const Text& text)
      : sheet_{text.file, text.encoding, {}, {}, {}}, lines_(lines_of(text.utf8)),
        cut_(!text.utf8.ends_with('\n') && !text.utf8.ends_with('\r')) {
    sheet_.dialect = dialect_of(lines_);
  }

  Sheet read() {
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      if (i % 65536 == 0) core::stop_if_asked();
      split(lines_[i], sheet_.dialect, cells_);
      line_ = static_cast<int>(i) + 1;
      const Census c = census(cells_, sheet_.dialect);
      if (c.filled == 0) continue;
      if (open_ ? continues(c) : c.numbers >= 2 && c.words <= c.numbers) {
        if (!open_) open_table();
        add_row();
      } else add_remark();
    }
    if (cut_) leave_out_cut_row();
    if (sheet_.tables.empty())
      throw InvalidInput(
          fmt::format("{}: there are no rows of numbers in two columns or more; read as {}, {}", sheet_.file,
                      sheet_.encoding, sheet_.dialect.words()));
    return std::move(sheet_);
  }

 private:
  bool continues(const Census& c) const {
    if (c.words == 0) return true; // also a row without any reading
    return c.numbers > 0 && ((c.numbers >= 2 && c.words <= c.numbers) ||
                             (cells_.size() == sheet_.tables.back().columns.size() &&
                              number_in(cells_.front(), sheet_.dialect)));
  }

  void add_remark() {
    open_ = false;
    pending_.push_back({line_, {cells_.begin(), cells_.end()}});
  }

  void open_table() {
    Table table;
    Remark units, header;
    if (!pending_.empty() && is_row_of_units(pending_.back())) {
      units = std::move(pending_.back());
      pending_.pop_back();
    }
    if (pending_.empty())
      throw InvalidInput(fmt::format("{}, line {}: numbers without a line above them that names the columns; "
                                     "write one, as 'travel_mm,force_N'",
                                     sheet_.file, line_));
    header = std::move(pending_.back());
    pending_.pop_back();
    refuse_row_as_header(header);
    if (!pending_.empty() && pending_.back().line == header.line - 1 && spans(pending_.back(), header))
      table.titles = pending_.back().cells;
    table.line = header.line;
    if (sheet_.dialect.delimiter == ' ' && header.cells.size() != cells_.size())
      join_words(header, cells_.size());
    auto& names = header.cells;
    while (!names.empty() && names.back().empty() && names.size() > cells_.size()) names.pop_back();
    while (!names.empty() && names.back().empty() && (cells_.size() < names.size() || cells_.back().empty()))
      names.pop_back();
    for (std::size_t k = 0; k < names.size(); ++k) {
      Column column{heading_of(names[k]), {}, {}};
      if (k < units.cells.size()) take_unit(column.heading, without_brackets(units.cells[k]), units.line);
      table.columns.push_back(std::move(column));
    }
    table.remarks = std::move(pending_);
    pending_.clear();
    sheet_.tables.push_back(std::move(table));
    open_ = true;
  }

  void take_unit(Heading& heading, const std::string& unit, int line) const {
    if (heading.unit.empty()) heading.unit = unit;
    const auto one = unit_named(heading.unit), other = unit_named(unit);
    if (one && other && (one->measures != other->measures || one->in_SI != other->in_SI))
      throw InvalidInput(
          fmt::format("{}, line {}, column {}: the header says {}, the row of units {}; one of them "
                      "is wrong",
                      sheet_.file, line, core::in_quotes(heading.text), heading.unit, unit));
  }

  /// Between blanks, names of several words come apart: "Load (N)   Travel (mm)".
  void join_words(Remark& header, std::size_t wanted) const {
    std::vector<std::string> wide, bracketed;
    const auto line = lines_[static_cast<std::size_t>(header.line) - 1];
    for (std::size_t start = line.find_first_not_of(' '); start < line.size();) {
      const auto stop = std::min({line.find("  ", start), line.find('\t', start), line.size()});
      wide.emplace_back(trimmed(line.substr(start, stop - start)));
      start = line.find_first_not_of(" \t", stop);
    }
    for (const auto& word : header.cells)
      if (!bracketed.empty() && (word.front() == '(' || word.front() == '[')) bracketed.back() += " " + word;
      else bracketed.push_back(word);
    if (wide.size() == wanted) header.cells = std::move(wide);
    else if (bracketed.size() == wanted) header.cells = std::move(bracketed);
  }

  /// A line between rows that begins with a word is a row whose first number is none.
  void refuse_row_as_header(const Remark& header) const {
    const bool numbers = std::ranges::any_of(
        header.cells, [&](const auto& cell) { return number_in(cell, sheet_.dialect).has_value(); });
    if (!numbers) return;
    if (!sheet_.tables.empty() && sheet_.tables.back().columns.size() == header.cells.size() &&
        !sheet_.tables.back().lines.empty() && sheet_.tables.back().lines.back() == header.line - 1)
      throw InvalidInput(fmt::format("{}, line {}, column {}: {} is not a number", sheet_.file, header.line,
                                     sheet_.tables.back().columns.front().heading.text,
                                     core::in_quotes(header.cells.front().substr(0, 40))));
    throw InvalidInput(fmt::format("{}, line {}: this line heads numbers but names no columns; above them "
                                   "must stand a line as 'travel_mm,force_N'",
                                   sheet_.file, header.line));
  }

  /// Titles stand above some of the columns, the first among them, or one of many specimens above each.
  static bool spans(const Remark& titles, const Remark& header) {
    std::size_t filled = 0;
    for (const auto& cell : titles.cells) filled += !cell.empty();
    return titles.cells.size() > 1 && titles.cells.size() + 2 >= header.cells.size() && filled >= 1 &&
           !titles.cells.front().empty() && 2 * filled <= header.cells.size();
  }

  void add_row() {
    Table& table = sheet_.tables.back();
    const auto row = table.lines.size();
    for (std::size_t k = table.columns.size(); k < cells_.size(); ++k)
      if (!cells_[k].empty())
        throw InvalidInput(fmt::format("{}, line {}: cell {} is {}, but the header in line {} has {} columns",
                                       sheet_.file, line_, k + 1, core::in_quotes(cells_[k].substr(0, 40)),
                                       table.line, table.columns.size()));
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
      auto& column = table.columns[k];
      const auto cell = k < cells_.size() ? cells_[k] : std::string_view{};
      const auto number = number_in(cell, sheet_.dialect);
      column.values.push_back(number.value_or(no_number));
      if (!number && !cell.empty() &&
          (column.words.size() < Column::kept || quantity_named(column.heading.name) == Quantity::particle))
        column.words.emplace_back(row, cell);
    }
    table.lines.push_back(line_);
  }

  /// A file that ends inside a row ends, more often than not, inside a number.
  void leave_out_cut_row() {
    Table& table = sheet_.tables.empty() ? none_ : sheet_.tables.back();
    if (table.lines.size() < 2 || table.lines.back() != static_cast<int>(lines_.size())) return;
    split(lines_[table.lines[table.lines.size() - 2] - 1], sheet_.dialect, cells_);
    const auto before = cells_.empty() ? std::string(1, ' ') : std::string(cells_.back());
    const auto cells_before = cells_.size();
    split(lines_.back(), sheet_.dialect, cells_);
    const auto decimals = [&](std::string_view cell) {
      const auto at = cell.find(sheet_.dialect.decimal_comma ? ',' : '.');
      return at == cell.npos ? 0 : cell.size() - at;
    };
    const bool shorter = cells_.size() < cells_before || decimals(cells_.back()) < decimals(before);
    if (!shorter) return;
    sheet_.said.push_back(fmt::format("line {}, the last, is cut: left out", table.lines.back()));
    table.lines.pop_back();
    for (auto& column : table.columns) {
      column.values.pop_back();
      while (!column.words.empty() && column.words.back().first >= table.lines.size())
        column.words.pop_back();
    }
  }

  Sheet sheet_;
  std::vector<std::string_view> lines_;
  bool cut_;
  Cells cells_;
  int line_ = 0;
  bool open_ = false;
  std::vector<Remark> pending_;
  Table none_;
};

} // namespace

std::string Remark::text() const {
  std::string all;
  for (const auto& cell : cells)
    if (!cell.empty()) all += (all.empty() ? "" : " ") + cell;
  return all;
}

Sheet read_sheet(const Text& text) { return Reader(text).read(); }

} // namespace platen::measure
