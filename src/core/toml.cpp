#include "core/toml.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/number.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>

namespace platen::core {
namespace {

Table copy(const toml::table&, const std::string& file, const std::string& name);

Value copy(const toml::node& node, const std::string& file, const std::string& name) {
  Value value{false, static_cast<int>(node.source().begin.line)};
  if (const auto* b = node.as_boolean()) value.data = b->get();
  else if (const auto* i = node.as_integer()) value.data = i->get();
  else if (const auto* x = node.as_floating_point()) value.data = x->get();
  else if (const auto* s = node.as_string()) value.data = s->get();
  else if (const auto* table = node.as_table()) value.data = copy(*table, file, name);
  else if (const auto* array = node.as_array()) {
    std::vector<Value> items;
    for (const auto& item : *array) items.push_back(copy(item, file, name));
    value.data = std::move(items);
  } else
    throw InvalidInput(
        fmt::format("{}, line {}: {} is a date or time, which no card uses", file, value.line, name));
  return value;
}

Table copy(const toml::table& source, const std::string& file, const std::string& name) {
  Table table{file, name, static_cast<int>(source.source().begin.line), {}};
  for (const auto& [key, node] : source) {
    const std::string dotted = name.empty() ? std::string(key.str()) : fmt::format("{}.{}", name, key.str());
    table.entries.push_back({std::string(key.str()), copy(node, file, dotted)});
  }
  std::stable_sort(table.entries.begin(), table.entries.end(),
                   [](const Entry& a, const Entry& b) { return a.value.line < b.value.line; });
  return table;
}

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

Table parse_toml(std::string_view text, const std::string& file) {
  try {
    return copy(toml::parse(text, file), file, "");
  } catch (const toml::parse_error& error) {
    std::string why(error.description());
    for (char& c : why)
      if (static_cast<unsigned char>(c) < 0x20) c = ' '; // it quotes the card, line breaks and all
    throw InvalidInput(fmt::format("{}, line {}, column {}: this is not TOML: {}", file,
                                   error.source().begin.line, error.source().begin.column, why));
  }
}

Table read_toml(const std::filesystem::path& path) {
  if (!is_there(path)) throw InvalidInput(fmt::format("{}: there is no such file", path.string()));
  const std::string text = read_file(path);
  if (const auto first = text.find_first_not_of(" \t\r\n"); first != text.npos && text[first] == '*')
    throw InvalidInput(
        fmt::format("{}: this looks like an input file of Abaqus or CalculiX; make a card of it with "
                    "platen convert {} --units SYSTEM -o MATERIAL.toml",
                    path.string(), path.filename().string()));
  return parse_toml(text, path.string());
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
