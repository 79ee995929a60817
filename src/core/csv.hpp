#pragma once
// Tables of numbers and words with "# key = value" lines before them.

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace platen::core {

struct Csv {
  struct Row {
    int line = 0;
    std::vector<std::string> cells;
  };
  std::string file;                                       ///< as messages name it
  std::vector<std::pair<std::string, std::string>> notes; ///< the "# key = value" lines
  std::vector<std::string> columns;
  std::vector<Row> rows;

  /// Empty when there is no such line.
  std::string note(std::string_view key) const;
  /// InvalidInput when the note is missing or is no finite number.
  double number_note(std::string_view key) const;
  /// Index of a column; InvalidInput, with the nearest column, when there is none.
  std::size_t column(std::string_view name) const;
  bool has_column(std::string_view name) const;
  /// The cell as a finite number; InvalidInput names line and column.
  double number(const Row&, std::size_t column) const;
};

/// InvalidInput for rows that are longer or shorter than the header, for two columns of one name, and for
/// text without a header.
Csv parse_csv(std::string_view text, const std::string& file);
Csv read_csv(const std::filesystem::path&);

} // namespace platen::core
