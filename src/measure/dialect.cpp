#include "measure/dialect.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace platen::measure {
namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

std::optional<double> plain_number(const char* begin, const char* end) {
  if (begin != end && *begin == '+') ++begin;
  double value = 0;
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) return {};
  return value;
}

/// Digits in groups of three before the decimal sign, as in 12.345.678.
bool grouped(std::string_view whole, char sign) {
  const auto first = whole.find(sign);
  if (first == 0 || first > 3 || first == whole.npos || whole.front() == '0') return false;
  std::size_t digits = 3;
  for (char c : whole.substr(first)) {
    if (c == sign) {
      if (digits != 3) return false;
      digits = 0;
    } else ++digits;
  }
  return digits == 3;
}

} // namespace

std::string Dialect::words() const {
  const std::string between = delimiter == '\t'  ? "tabs"
                              : delimiter == ';' ? "semicolons"
                              : delimiter == ',' ? "commas"
                                                 : "blanks";
  return between + (decimal_comma ? ", decimal comma" : ", decimal point");
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  const char end = text.find('\n') == text.npos ? '\r' : '\n';
  for (std::size_t start = 0; start < text.size();) {
    const auto stop = std::min(text.find(end, start), text.size());
    auto line = text.substr(start, stop - start);
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.push_back(line);
    start = stop + 1;
  }
  return lines;
}

void split(std::string_view line, const Dialect& dialect, std::vector<std::string_view>& cells) {
  cells.clear();
  const bool blanks = dialect.delimiter == ' ';
  for (std::size_t start = 0; start <= line.size();) {
    if (blanks) {
      start = line.find_first_not_of(" \t", start);
      if (start == line.npos) return;
    }
    const auto open = line.find_first_not_of(' ', start);
    std::size_t from = start;
    if (open != line.npos && line[open] == '"')
      if (const auto close = line.find('"', open + 1); close != line.npos) from = close;
    const auto stop =
        std::min(blanks ? line.find_first_of(" \t", from) : line.find(dialect.delimiter, from), line.size());
    auto cell = trimmed(line.substr(start, stop - start));
    if (cell.size() > 1 && cell.front() == '"' && cell.back() == '"')
      cell = trimmed(cell.substr(1, cell.size() - 2));
    cells.push_back(cell);
    start = stop + 1;
  }
}

std::optional<double> number_in(std::string_view cell, const Dialect& dialect) {
  if (cell.empty() || cell.size() > 60) return {};
  const char last = cell.back();
  if ((last < '0' || last > '9') && last != '.' && last != ',') return {};
  constexpr std::string_view minus = "\u2212";
  std::array<char, 64> buffer{};
  std::size_t n = 0;
  if (cell.starts_with(minus)) {
    buffer[n++] = '-';
    cell.remove_prefix(minus.size());
  }
  const char decimal = dialect.decimal_comma ? ',' : '.', thousands = dialect.decimal_comma ? '.' : ',';
  if (cell.find(thousands) == cell.npos && decimal == '.' && n == 0)
    return plain_number(cell.data(), cell.data() + cell.size());
  bool strip = false;
  if (cell.find(thousands) != cell.npos) {
    auto whole = cell.substr(0, std::min(cell.find(decimal), cell.size()));
    if (whole.starts_with('-') || whole.starts_with('+')) whole.remove_prefix(1);
    if (!grouped(whole, thousands)) return {};
    strip = true;
  }
  for (char c : cell) {
    if (strip && c == thousands) continue;
    if (c == thousands) return {};
    buffer[n++] = c == decimal ? '.' : c;
  }
  return plain_number(buffer.data(), buffer.data() + n);
}

bool is_no_reading(std::string_view cell) {
  if (cell.empty()) return true;
  if (cell.find_first_not_of("-*#?=.\u2014\u2013") == cell.npos && cell.size() > 1) return true;
  static constexpr std::array words = {
      "nan",      "-nan",  "inf",  "-inf",  "+inf",    "over",   "ovr",    "overload", "ol",
      "o.l.",     "n/a",   "#n/a", "na",    "null",    "none",   "under",  "overflow", "ueberlast",
      "überlast", "#num!", "err",  "error", "1.#qnan", "1.#inf", "-1.#ind"};
  return std::ranges::find(words, lower(cell)) != words.end();
}

Dialect dialect_of(const std::vector<std::string_view>& lines) {
  Dialect best;
  std::size_t most = 0;
  std::vector<std::string_view> cells;
  constexpr std::size_t sampled = 2000;
  for (const char delimiter : {'\t', ';', ',', ' '})
    for (const bool comma : {false, true}) {
      const Dialect dialect{delimiter, comma};
      std::size_t score = 0;
      for (std::size_t i = 0; i < std::min(lines.size(), sampled); ++i) {
        split(lines[i], dialect, cells);
        std::size_t numbers = 0, words = 0;
        for (const auto cell : cells) {
          if (number_in(cell, dialect)) ++numbers;
          else words += !is_no_reading(cell);
        }
        if (numbers >= 2 && words <= 1) score += words == 0 ? 2 : 1;
      }
      if (score > most) most = score, best = dialect;
    }
  return best;
}

} // namespace platen::measure
