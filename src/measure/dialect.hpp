#pragma once
// How a file writes its rows: what stands between two cells, and which sign parts a number.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace platen::measure {

struct Dialect {
  char delimiter = ','; ///< ' ': any run of blanks
  bool decimal_comma = false;

  std::string words() const; ///< "semicolons, decimal comma"
};

std::string_view trimmed(std::string_view);

/// The lines of a text, without their ends.
std::vector<std::string_view> lines_of(std::string_view text);

/// The cells of a line without quotes and blanks around them; empty ones at its end stay.
void split(std::string_view line, const Dialect&, std::vector<std::string_view>& cells);

/// The whole cell as a finite number, also with a thousands sign in it ("1.234,5" with decimal comma).
std::optional<double> number_in(std::string_view cell, const Dialect&);

/// "-----", "OVER", "NaN" and the like: what instruments write where they have no reading.
bool is_no_reading(std::string_view cell);

/// The dialect in which most lines are rows of numbers.
Dialect dialect_of(const std::vector<std::string_view>& lines);

} // namespace platen::measure
