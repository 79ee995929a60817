#pragma once
// A TOML document as plain values that know their line, so that what is wrong with one can be said precisely.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace platen::core {

struct Value;
struct Entry;

struct Table {
  std::string file; ///< as messages name it
  std::string name; ///< dotted: "parameters", "material.parameters"; empty at the top
  int line = 0;
  std::vector<Entry> entries; ///< in the order of the file

  const Value* find(std::string_view key) const;
};

struct Value {
  std::variant<bool, std::int64_t, double, std::string, std::vector<Value>, Table> data;
  int line = 0;
};

struct Entry {
  std::string key;
  Value value;
};

/// InvalidInput with file and line for malformed text.
Table parse_toml(std::string_view text, const std::string& file);
/// InvalidInput when there is no such file: the user named it.
Table read_toml(const std::filesystem::path&);

/// The section [name] of a card, null when it is not there. InvalidInput when `name` is something else.
const Table* section(const Table& card, std::string_view name);

/// The value as it would stand in a card, cut short where it is long; for messages.
std::string text_of(const Value&);
/// "text", "a number", "a table", ...
std::string_view kind_of(const Value&);
/// "card.toml, line 5: [parameters] E_Pa": the beginning of every message about a key.
std::string place(const Table&, std::string_view key);
/// A TOML string with its quotes; anything unprintable escaped.
std::string in_quotes(std::string_view);

} // namespace platen::core
