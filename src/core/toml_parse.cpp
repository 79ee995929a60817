#include "core/error.hpp"
#include "core/file.hpp"
#include "core/toml.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <memory>

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

/// toml++ reads numbers through a stream, which calls one that it has no memory for no number. What is wrong
/// in the text is wrong a second time, with more memory at hand.
toml::table parse(std::string_view text, const std::string& file) {
  auto held_back = std::make_unique<char[]>(1 << 16);
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error&) { held_back.reset(); }
  return toml::parse(text, file);
}

} // namespace

Table parse_toml(std::string_view text, const std::string& file) {
  try {
    return copy(parse(text, file), file, "");
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

} // namespace platen::core
