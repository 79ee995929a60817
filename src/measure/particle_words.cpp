#include "measure/particle_words.hpp"

#include <algorithm>

namespace platen::measure {
namespace {

/// "1.20mm" → "1.20 mm"; "d=1.2" → "d 1.2".
std::string spaced(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i], next = i + 1 < text.size() ? text[i + 1] : ' ';
    const bool digit = c >= '0' && c <= '9';
    result += c == '=' || c == ':' ? ' ' : c;
    const bool exponent =
        (next == 'e' || next == 'E') && i + 2 < text.size() &&
        (text[i + 2] == '-' || text[i + 2] == '+' || (text[i + 2] >= '0' && text[i + 2] <= '9'));
    const bool letter = (next >= 'a' && next <= 'z') || (next >= 'A' && next <= 'Z') || next < 0;
    if (digit && letter && !exponent) result += ' ';
  }
  return result;
}

std::string_view without_end(std::string_view token) {
  while (!token.empty() && (token.back() == ',' || token.back() == ';' || token.back() == ')'))
    token.remove_suffix(1);
  return token;
}

} // namespace

std::optional<double> diameter_in(const std::string& text, const Dialect& dialect) {
  const std::string all = spaced(text);
  std::vector<std::string_view> tokens;
  split(all, {' ', false}, tokens);
  std::string words;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const auto token = without_end(tokens[i]);
    auto number = number_in(token, dialect);
    if (!number) number = number_in(token, {' ', !dialect.decimal_comma});
    if (!number) {
      words += (words.empty() ? "" : " ") + std::string(tokens[i]);
      continue;
    }
    const Heading heading = heading_of(words);
    const Quantity what = quantity_named(heading.name);
    words.clear();
    if (what != Quantity::diameter && what != Quantity::radius) continue;
    auto unit = unit_named(heading.unit);
    if (!unit && i + 1 < tokens.size()) unit = unit_named(without_end(tokens[i + 1]));
    if (!unit || unit->measures != Quantity::displacement || !(*number > 0)) continue;
    return *number * unit->in_SI * (what == Quantity::radius ? 2 : 1);
  }
  return {};
}

bool names_particle(const std::string& text, const Dialect& dialect) {
  if (diameter_in(text, dialect)) return true;
  std::vector<std::string_view> tokens;
  split(text, {' ', false}, tokens);
  std::string words;
  for (const auto token : tokens) {
    if (token.find_first_of("0123456789") != token.npos) break;
    words += std::string(token) + ' ';
  }
  return tokens.size() <= 6 && quantity_named(words) == Quantity::particle;
}

std::string particle_name(const std::string& text) {
  const auto end = std::min(text.find(','), text.find(';'));
  std::string name(trimmed(text.substr(0, std::min(end, text.size()))));
  std::erase(name, ':');
  return name;
}

} // namespace platen::measure
