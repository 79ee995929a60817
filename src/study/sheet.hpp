#pragma once
// A table of numbers and words, as CSV and as SQLite.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace platen::study {

/// Nothing, a whole number, a number, a word.
using Cell = std::variant<std::monostate, std::int64_t, double, std::string>;

struct Sheet {
  std::string name;                                       ///< of the table in SQLite
  std::vector<std::pair<std::string, std::string>> notes; ///< "# key = value" lines of the CSV
  std::vector<std::string> columns;
  std::vector<std::vector<Cell>> rows;
};

std::string csv_text(const Sheet&);

/// Whether the name of a file asks for SQLite.
bool is_sqlite(std::string_view file);

/// A new database with a table for each sheet, and a table `notes` (sheet, key, value); written under another
/// name, then renamed. IoError where it cannot be written.
void write_sqlite(const std::filesystem::path&, const std::vector<Sheet>&);

} // namespace platen::study
