#include "core/toml.hpp"

#include "core/error.hpp"
#include "core/number.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace platen::core {
namespace {

std::string shortened(std::string text) {
  constexpr std::size_t longest = 60;
  if (text.size() > longest) {
    text.resize(longest - 3);
    while (!text.empty() && (text.back() & 0xc0) == 0x80) text.pop_back(); // not in the middle of a character
    text += "...";
  }
  return text;
}

} // namespace

const Value* Table::find(std::string_view key) const {
  for (const auto& entry : entries)
    if (entry.key == key) return &entry.value;
  return nullptr;
}

const Table* section(const Table& card, std::string_view name) {
  const Value* value = card.find(name);
  if (!value) return nullptr;
  if (const auto* table = std::get_if<Table>(&value->data)) return table;
  throw InvalidInput(fmt::format("{} = {} is {}; it must be a section, [{}]", place(card, name),
                                 text_of(*value), kind_of(*value), name));
}

std::string text_of(const Value& value) {
  struct Text {
    std::string operator()(bool b) const { return b ? "true" : "false"; }
    std::string operator()(std::int64_t i) const { return std::to_string(i); }
    std::string operator()(double x) const { return number_text(x); }
    std::string operator()(const std::string& s) const { return in_quotes(s); }
    std::string operator()(const Table&) const { return "{...}"; }
    std::string operator()(const std::vector<Value>& items) const {
      std::string list = "[";
      for (const auto& item : items) {
        if (list.size() > 80) break;
        list += (list.size() > 1 ? ", " : "") + std::visit(*this, item.data);
      }
      return list + "]";
    }
  };
  return shortened(std::visit(Text{}, value.data));
}

std::string_view kind_of(const Value& value) {
  constexpr std::string_view kinds[] = {"true or false", "a whole number", "a number",
                                        "text",          "a list",         "a table"};
  return kinds[value.data.index()];
}

std::string place(const Table& table, std::string_view key) {
  const Value* value = table.find(key);
  const int line = value ? value->line : table.line;
  return fmt::format("{}{}: {}{}", table.file, line > 0 ? fmt::format(", line {}", line) : "",
                     table.name.empty() ? "" : fmt::format("[{}] ", table.name), key);
}

std::string in_quotes(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') (result += '\\') += c;
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) result += fmt::format("\\u{:04x}", c);
    else result += c;
  }
  return result + "\"";
}

} // namespace platen::core
