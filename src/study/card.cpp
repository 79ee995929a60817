#include "study/card.hpp"

#include "core/catalogue.hpp"
#include "core/error.hpp"
#include "core/fields.hpp"
#include "core/number.hpp"
#include "core/toml.hpp"
#include "press/case_card.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace platen::study {
namespace {

using core::Field, core::Table, core::Value;

struct Head {
  int platen = 1;
  std::string name;
};
const std::vector<Field<Head>> head_fields = {
    {"platen", &Head::platen, "format of the card", core::closed(1, 1)},
    {"name", &Head::name, "name of the study"},
};

struct Design {
  std::string kind = "factorial";
  int seed = 1;
};
const std::vector<Field<Design>> design_fields = {
    {"kind", &Design::kind, "factorial: every combination of the values"},
    Field<Design>{"seed", &Design::seed, "seed of random designs", core::closed(0, 1e9)}.optional(),
};

struct Factor {
  std::vector<double> values;
};
const std::vector<Field<Factor>> factor_fields = {{"values", &Factor::values, "the values it takes"}};

const std::string& text(const Table& table, std::string_view key, const Value& value) {
  if (const auto* string = std::get_if<std::string>(&value.data)) return *string;
  throw core::InvalidInput(fmt::format("{} = {} is {}; it must be text", core::place(table, key),
                                       core::text_of(value), core::kind_of(value)));
}

const Table& needed(const Table& card, std::string_view name) {
  if (const Table* table = core::section(card, name)) return *table;
  throw core::InvalidInput(fmt::format("{}: the section [{}] is missing", card.file, name));
}

core::Entry* entry(Table& table, std::string_view key) {
  const auto found = std::find_if(table.entries.begin(), table.entries.end(),
                                  [&](const core::Entry& e) { return e.key == key; });
  return found == table.entries.end() ? nullptr : &*found;
}

/// The base case with its material as a table, so that factors can reach into it.
Table base_case(const Table& card) {
  const Value* value = card.find("case");
  if (!value)
    throw core::InvalidInput(
        fmt::format("{}: case is missing: the path of a case card, or a table", card.file));
  Table base;
  if (const auto* table = std::get_if<Table>(&value->data)) base = *table;
  else base = core::read_toml(std::filesystem::path(card.file).parent_path() / text(card, "case", *value));
  if (core::Entry* material = entry(base, "material"))
    if (const auto* what = std::get_if<std::string>(&material->value.data)) {
      const auto beside = std::filesystem::path(base.file).parent_path() / *what;
      material->value.data = core::read_toml(
          std::filesystem::is_regular_file(beside) ? beside : core::find_card("materials", *what));
    }
  return base;
}

/// E_bar and E_Pa name one quantity: giving one takes the other away.
std::string counterpart(const std::string& key) {
  if (key.ends_with("_bar")) return key.substr(0, key.size() - 4) + "_Pa";
  if (key.ends_with("_Pa")) return key.substr(0, key.size() - 3) + "_bar";
  return {};
}

/// "material.E_bar" is material.parameters.E_bar; others are [section].key of the case, or a key at its top.
void set(Table& base, const std::string& factor, double number) {
  const auto dot = factor.find('.');
  Table* table = &base;
  const std::string key = dot == std::string::npos ? factor : factor.substr(dot + 1);
  std::vector<std::string> path;
  if (dot != std::string::npos) path.push_back(factor.substr(0, dot));
  if (!path.empty() && path[0] == "material") path.push_back("parameters");
  for (const auto& name : path) {
    core::Entry* next = entry(*table, name);
    if (!next) {
      Table empty;
      empty.file = table->file;
      empty.name = name;
      table->entries.push_back({name, {empty, 0}});
      next = &table->entries.back();
    }
    table = std::get_if<Table>(&next->value.data);
    if (!table) throw core::InvalidInput(fmt::format("factor '{}': {} is no table", factor, name));
  }
  std::erase_if(table->entries,
                [&](const core::Entry& e) { return e.key == key || e.key == counterpart(key); });
  Value value;
  if (key == "elements") value.data = static_cast<std::int64_t>(number);
  else value.data = number;
  table->entries.push_back({key, value});
}

std::vector<std::vector<double>> factorial(const std::vector<std::vector<double>>& levels) {
  std::vector<std::vector<double>> points = {{}};
  for (const auto& values : levels) {
    std::vector<std::vector<double>> longer;
    for (const auto& point : points)
      for (const double value : values) {
        longer.push_back(point);
        longer.back().push_back(value);
      }
    points = std::move(longer);
  }
  return points;
}

std::vector<std::string> laws(const Table& card) {
  const Table* fit = core::section(card, "fit");
  if (!fit) return {};
  core::refuse_unknown_keys(*fit, std::vector<std::string>{"laws"});
  std::vector<std::string> names;
  if (const Value* value = fit->find("laws")) {
    const auto* list = std::get_if<std::vector<Value>>(&value->data);
    if (!list) throw core::InvalidInput(fmt::format("{} must be a list of names", core::place(*fit, "laws")));
    for (const auto& item : *list) {
      names.push_back(text(*fit, "laws", item));
      if (names.back() != "edmans-sinka")
        throw core::InvalidInput(fmt::format("{}: '{}' cannot be fitted to a curve; known is: edmans-sinka",
                                             core::place(*fit, "laws"), names.back()));
    }
  }
  return names;
}

} // namespace

Study read_study(std::string_view path) {
  const Table card = core::read_toml(path);
  const Head head = core::read_fields<Head>(card, head_fields, {},
                                            std::vector<std::string>{"case", "design", "factors", "fit"});
  const Table& design_table = needed(card, "design");
  const Design design = core::read_fields<Design>(design_table, design_fields);
  if (design.kind != "factorial")
    throw core::InvalidInput(fmt::format("{} = \"{}\" is not available; available is: factorial",
                                         core::place(design_table, "kind"), design.kind));
  Study study{card.file, head.name, {}, laws(card), {}};
  const Table& factors = needed(card, "factors");
  std::vector<std::vector<double>> levels;
  for (const auto& [key, value] : factors.entries) {
    const auto* table = std::get_if<Table>(&value.data);
    if (!table)
      throw core::InvalidInput(
          fmt::format("{} must be a table: {{ values = [...] }}", core::place(factors, key)));
    study.factors.push_back(key);
    levels.push_back(core::read_fields<Factor>(*table, factor_fields).values);
  }
  const Table base = base_case(card);
  const auto points = factorial(levels);
  if (points.empty() || study.factors.empty())
    throw core::InvalidInput(
        fmt::format("{}: the design is empty; give each factor at least one value", card.file));
  for (const auto& point : points) {
    Table one = base;
    for (std::size_t i = 0; i < point.size(); ++i) set(one, study.factors[i], point[i]);
    try {
      study.runs.push_back({point, press::read_case(one)});
    } catch (const core::InvalidInput& problem) {
      std::string at;
      for (std::size_t i = 0; i < point.size(); ++i)
        at += fmt::format("{}{} = {}", i ? ", " : "", study.factors[i], core::number_text(point[i]));
      throw core::InvalidInput(fmt::format("{}: the run with {}: {}", card.file, at, problem.what()));
    }
  }
  return study;
}

} // namespace platen::study
