#include "core/csv.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/nearest.hpp"
#include "core/number.hpp"
#include "core/toml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace platen::core {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> cells;
  for (std::size_t start = 0; start <= line.size();) {
    const auto comma = std::min(line.find(',', start), line.size());
    cells.emplace_back(trimmed(line.substr(start, comma - start)));
    start = comma + 1;
  }
  return cells;
}

void add_note(Csv& csv, std::string_view line) {
  const auto equals = line.find('=');
  if (equals == std::string_view::npos) return; // a remark
  csv.notes.emplace_back(trimmed(line.substr(1, equals - 1)), trimmed(line.substr(equals + 1)));
}

void set_columns(Csv& csv, std::vector<std::string> names, int line) {
  auto sorted = names;
  std::sort(sorted.begin(), sorted.end());
  if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end())
    throw InvalidInput(
        fmt::format("{}, line {}: column {} stands there twice", csv.file, line, in_quotes(*twice)));
  csv.columns = std::move(names);
}

} // namespace

std::string Csv::note(std::string_view key) const {
  for (const auto& [name, value] : notes)
    if (name == key) return value;
  return {};
}

double Csv::number_note(std::string_view key) const {
  const std::string text = note(key);
  if (text.empty()) throw InvalidInput(fmt::format("{}: the line '# {} = number' is missing", file, key));
  const auto value = number_from(text);
  if (!value || !std::isfinite(*value))
    throw InvalidInput(fmt::format("{}: # {} = {} is not a finite number", file, key, in_quotes(text)));
  return *value;
}

bool Csv::has_column(std::string_view name) const {
  return std::find(columns.begin(), columns.end(), name) != columns.end();
}

std::size_t Csv::column(std::string_view name) const {
  const auto found = std::find(columns.begin(), columns.end(), name);
  if (found == columns.end()) {
    const std::string close = nearest(name, columns);
    throw InvalidInput(
        fmt::format("{}: column {} is missing{}", file, name,
                    close.empty() ? "" : fmt::format("; the nearest one there is {}", in_quotes(close))));
  }
  return found - columns.begin();
}

double Csv::number(const Row& row, std::size_t column) const {
  const auto value = number_from(row.cells[column]);
  if (!value || !std::isfinite(*value))
    throw InvalidInput(fmt::format("{}, line {}, column {}: {} is not a finite number", file, row.line,
                                   columns[column], in_quotes(row.cells[column].substr(0, 40))));
  return *value;
}

Csv parse_csv(std::string_view text, const std::string& file) {
  Csv csv{file, {}, {}, {}};
  int number = 0;
  for (std::size_t start = 0; start < text.size();) {
    const auto end = std::min(text.find('\n', start), text.size());
    const auto line = trimmed(text.substr(start, end - start));
    start = end + 1;
    ++number;
    if (line.empty()) continue;
    if (line.front() == '#') add_note(csv, line);
    else if (csv.columns.empty()) set_columns(csv, cells_of(line), number);
    else {
      auto cells = cells_of(line);
      if (cells.size() != csv.columns.size())
        throw InvalidInput(fmt::format("{}, line {}: {} cells where the header has {} columns", file, number,
                                       cells.size(), csv.columns.size()));
      csv.rows.push_back({number, std::move(cells)});
    }
  }
  if (csv.columns.empty())
    throw InvalidInput(fmt::format("{}: no header line with the names of the columns", file));
  return csv;
}

Csv read_csv(const std::filesystem::path& path) {
  if (!is_there(path)) throw InvalidInput(fmt::format("{}: there is no such file", path.string()));
  return parse_csv(read_file(path), path.string());
}

} // namespace platen::core
