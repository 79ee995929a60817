#include "study/factor.hpp"

#include "core/catalogue.hpp"
#include "core/error.hpp"
#include "core/number.hpp"
#include "core/unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace platen::study {
namespace {

using core::Table, core::Value;

core::Entry* entry(Table& table, std::string_view key) {
  const auto found = std::find_if(table.entries.begin(), table.entries.end(),
                                  [&](const core::Entry& e) { return e.key == key; });
  return found == table.entries.end() ? nullptr : &*found;
}

/// They name keys of the card, which a factor may take away.
void drop_sources(Table& material) {
  std::erase_if(material.entries, [](const core::Entry& e) { return e.key == "source"; });
}

Table material_table(const std::string& case_file, const std::string& what) {
  const auto beside = std::filesystem::path(case_file).parent_path() / what;
  Table material =
      core::read_toml(std::filesystem::is_regular_file(beside) ? beside : core::find_card("materials", what));
  drop_sources(material);
  return material;
}

/// E_bar and E_Pa name one quantity: giving one takes the other away.
std::string counterpart(const std::string& key) {
  if (key.ends_with("_bar")) return key.substr(0, key.size() - 4) + "_Pa";
  if (key.ends_with("_Pa")) return key.substr(0, key.size() - 3) + "_bar";
  return {};
}

/// "material.hardening.kappa_Pa" → material, parameters, hardening, kappa_Pa.
std::vector<std::string> path_of(const std::string& factor) {
  std::vector<std::string> path;
  for (std::size_t start = 0; start <= factor.size();) {
    const auto dot = std::min(factor.find('.', start), factor.size());
    path.push_back(factor.substr(start, dot - start));
    start = dot + 1;
  }
  if (path[0] == "material" && path.size() > 1) path.insert(path.begin() + 1, "parameters");
  return path;
}

Value value_of(const Level& level) {
  Value value;
  if (const auto* word = std::get_if<std::string>(&level)) value.data = *word;
  else if (const double x = std::get<double>(level); x == std::floor(x) && std::abs(x) < 1e9)
    value.data = static_cast<std::int64_t>(x); // cards take a whole number for a number, and not the reverse
  else value.data = x;
  return value;
}

} // namespace

std::string text_of(const Level& level) {
  if (const auto* word = std::get_if<std::string>(&level)) return *word;
  return core::number_text(std::get<double>(level));
}

Table base_case(const Table& card) {
  const Value* value = card.find("case");
  if (!value)
    throw core::InvalidInput(
        fmt::format("{}: case is missing: the path of a case card, or a table", card.file));
  Table base;
  if (const auto* table = std::get_if<Table>(&value->data)) base = *table;
  else if (const auto* path = std::get_if<std::string>(&value->data))
    base = core::read_toml(std::filesystem::path(card.file).parent_path() / *path);
  else
    throw core::InvalidInput(fmt::format("{} = {} is {}; it must be the path of a case card, or a table",
                                         core::place(card, "case"), core::text_of(*value),
                                         core::kind_of(*value)));
  if (core::Entry* material = entry(base, "material")) {
    if (const auto* what = std::get_if<std::string>(&material->value.data))
      material->value.data = material_table(base.file, *what);
    else if (auto* written = std::get_if<Table>(&material->value.data)) drop_sources(*written);
  }
  return base;
}

void set(Table& base, const std::string& factor, const Level& level) {
  auto path = path_of(factor);
  const std::string key = path.back();
  path.pop_back();
  Table* table = &base;
  for (const auto& name : path) {
    core::Entry* next = entry(*table, name);
    if (!next) {
      Table empty;
      empty.file = table->file;
      empty.name = table->name.empty() ? name : table->name + "." + name;
      table->entries.push_back({name, {empty, 0}});
      next = &table->entries.back();
    }
    table = std::get_if<Table>(&next->value.data);
    if (!table) throw core::InvalidInput(fmt::format("factor '{}': {} is no table", factor, name));
  }
  const std::array names{key, counterpart(key)}; // and E = "2 GPa" is E_Pa
  std::erase_if(table->entries, [&](const core::Entry& e) {
    return e.key == names[0] || e.key == names[1] || !core::si_key(e.key, names).empty();
  });
  Value value = value_of(level);
  if (factor == "material") value.data = material_table(base.file, text_of(level));
  table->entries.push_back({key, std::move(value)});
}

} // namespace platen::study
