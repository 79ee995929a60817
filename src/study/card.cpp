#include "study/card.hpp"

#include "core/catalogue.hpp"
#include "core/error.hpp"
#include "core/fields.hpp"
#include "core/nearest.hpp"
#include "core/number.hpp"
#include "core/parallel.hpp"
#include "core/unit.hpp"
#include "press/case_card.hpp"
#include "study/derived.hpp"
#include "study/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

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
  std::string kind = "factorial", file;
  int seed = 1, runs = 0;
};
const std::vector<Field<Design>> design_fields = {
    {"kind", &Design::kind,
     "factorial: every combination of the values; latin-hypercube, space-filling: so many runs over the "
     "ranges; table: the rows of a file"},
    Field<Design>{"runs", &Design::runs, "number of runs of a latin hypercube or a space-filling design",
                  core::closed(2, 2000)}
        .optional(),
    Field<Design>{"seed", &Design::seed, "seed of these", core::closed(0, 1e9)}.optional(),
    Field<Design>{"file", &Design::file, "CSV of a table, beside the card or among the catalogue's tables"}
        .optional(),
};
const std::vector<std::string> kinds = {"factorial", "latin-hypercube", "space-filling", "table"};

const std::vector<Field<Factor>> range_fields = {
    {"min", &Factor::min, "lower end of the range"},
    {"max", &Factor::max, "upper end"},
};
const std::vector<std::string> factor_keys = {"values", "min", "max", "scale", "column", "names"};

const std::string& text(const Table& table, std::string_view key, const Value& value) {
  if (const auto* string = std::get_if<std::string>(&value.data)) return *string;
  throw core::InvalidInput(fmt::format("{} = {} is {}; it must be text", core::place(table, key),
                                       core::text_of(value), core::kind_of(value)));
}

const Table& needed(const Table& card, std::string_view name) {
  if (const Table* table = core::section(card, name)) return *table;
  throw core::InvalidInput(fmt::format("{}: the section [{}] is missing", card.file, name));
}

std::map<std::string, std::string> words(const Table& table) {
  std::map<std::string, std::string> result;
  for (const auto& [key, value] : table.entries) result[key] = text(table, key, value);
  return result;
}

std::vector<Level> read_values(const Table& table, const Value& value) {
  const auto* list = std::get_if<std::vector<Value>>(&value.data);
  if (!list)
    throw core::InvalidInput(
        fmt::format("{} = {} must be a list", core::place(table, "values"), core::text_of(value)));
  std::vector<Level> levels;
  for (const auto& item : *list) {
    if (const auto* x = std::get_if<double>(&item.data)) levels.emplace_back(*x);
    else if (const auto* i = std::get_if<std::int64_t>(&item.data))
      levels.emplace_back(static_cast<double>(*i));
    else if (const auto* word = std::get_if<std::string>(&item.data)) levels.emplace_back(*word);
    else
      throw core::InvalidInput(fmt::format("{}: {} is {}; values are numbers or text",
                                           core::place(table, "values"), core::text_of(item),
                                           core::kind_of(item)));
  }
  return levels;
}

bool read_scale(const Table& table, const Factor& factor) {
  const Value* value = table.find("scale");
  if (!value) return false;
  const std::string& scale = text(table, "scale", *value);
  if (scale != "log" && scale != "linear")
    throw core::InvalidInput(
        fmt::format("{} = \"{}\"; it must be \"linear\" or \"log\"", core::place(table, "scale"), scale));
  if (scale == "log" && !(factor.min > 0))
    throw core::InvalidInput(fmt::format("{} = \"log\" needs min > 0, not {}", core::place(table, "scale"),
                                         core::number_text(factor.min)));
  return scale == "log";
}

/// Where levels carry units, "material.E" = { values = ["1 GPa", "2 GPa"] }, they become numbers, and the
/// factor gets the name that is returned, material.E_Pa.
std::string levels_in_si(const std::string& name, Table& factor) {
  std::vector<std::pair<std::string, Value*>> levels;
  for (auto& [key, value] : factor.entries) {
    if (key == "min" || key == "max") levels.emplace_back(key, &value);
    if (auto* list = std::get_if<std::vector<Value>>(&value.data); list && key == "values")
      for (auto& item : *list) levels.emplace_back(key, &item);
  }
  std::optional<core::Quantity> first;
  for (const auto& [key, level] : levels)
    if (const auto* text = std::get_if<std::string>(&level->data); text && !first)
      first = core::quantity_from(*text);
  if (!first) return name;
  const std::string unit = "_" + first->si;
  if (name.ends_with(unit))
    throw core::InvalidInput(
        fmt::format("{}: the values have a unit, and the name of the factor has one too; write \"{}\"",
                    core::place(factor, levels.front().first), name.substr(0, name.size() - unit.size())));
  for (const auto& [key, level] : levels) {
    const auto* text = std::get_if<std::string>(&level->data);
    level->data =
        core::value_in_si(core::place(factor, key), text ? *text : core::text_of(*level), name + unit);
  }
  return name + unit;
}

Factor read_factor(const Table& factors, const std::string& written_name, const Value& value,
                   const std::string& kind) {
  Value in_si = value;
  auto* table = std::get_if<Table>(&in_si.data);
  const std::string name = table ? levels_in_si(written_name, *table) : written_name;
  if (!table)
    throw core::InvalidInput(fmt::format("{} must be a table: {{ {} }}", core::place(factors, name),
                                         kind == "table" ? "column = \"...\"" : "values = [...]"));
  core::refuse_unknown_keys(*table, factor_keys);
  const auto serves = [&](const char* key, bool here) {
    if (table->find(key) && !here)
      throw core::InvalidInput(
          fmt::format("{} is not for a design of kind \"{}\"", core::place(*table, key), kind));
  };
  const bool tabular = kind == "table", ranges = kind == "latin-hypercube" || kind == "space-filling";
  for (const char* key : {"column", "names"}) serves(key, tabular);
  for (const char* key : {"min", "max", "scale"}) serves(key, ranges);
  serves("values", !tabular);

  Factor factor;
  if (const Value* values = table->find("values")) {
    if (ranges) // one or the other
      core::refuse_unknown_keys(*table, std::vector<std::string>{"values"});
    factor.values = read_values(*table, *values);
    if (factor.values.empty())
      throw core::InvalidInput(
          fmt::format("{} = []: the design is empty; give each factor at least one value",
                      core::place(*table, "values")));
  } else if (ranges) {
    factor = core::read_fields(*table, range_fields, factor, std::vector<std::string>{"scale"});
    if (!(factor.min < factor.max))
      throw core::InvalidInput(fmt::format("{} = {} must be above min = {}", core::place(*table, "max"),
                                           core::number_text(factor.max), core::number_text(factor.min)));
    factor.log = read_scale(*table, factor);
  } else if (!tabular)
    throw core::InvalidInput(fmt::format("{}: values are missing", core::place(factors, name)));
  factor.name = name;
  factor.column = name;
  if (const Value* column = table->find("column")) factor.column = text(*table, "column", *column);
  if (const Table* names = core::section(*table, "names")) factor.names = words(*names);
  return factor;
}

std::vector<std::string> read_laws(const Table& card) {
  const Table* fit = core::section(card, "fit");
  if (!fit) return {};
  core::refuse_unknown_keys(*fit, std::vector<std::string>{"laws"});
  std::vector<std::string> names;
  if (const Value* value = fit->find("laws")) {
    const auto* list = std::get_if<std::vector<Value>>(&value->data);
    if (!list) throw core::InvalidInput(fmt::format("{} must be a list of names", core::place(*fit, "laws")));
    for (const auto& item : *list) {
      names.push_back(text(*fit, "laws", item));
      if (const auto known = fitted_laws();
          std::find(known.begin(), known.end(), names.back()) == known.end())
        throw core::InvalidInput(
            fmt::format("{}: '{}' cannot be fitted to the curves of a study; known are: {}",
                        core::place(*fit, "laws"), names.back(), fmt::join(known, ", ")));
    }
  }
  return names;
}

struct Bound {
  const Derived* quantity;
  double low, high;
};

std::vector<Bound> read_bounds(const Table& card, const std::string& kind) {
  const Table* table = core::section(card, "bounds");
  if (!table) return {};
  if (kind != "space-filling")
    throw core::InvalidInput(fmt::format(
        "{}: [bounds] are for a design of kind \"space-filling\"; the runs of a \"{}\" are all kept",
        card.file, kind));
  std::vector<std::string> known;
  for (const auto& derived : derived_quantities()) known.push_back(derived.name);
  core::refuse_unknown_keys(*table, known);
  std::vector<Bound> bounds;
  for (const auto& derived : derived_quantities()) {
    if (!table->find(derived.name)) continue;
    struct Ends {
      std::vector<double> list;
    };
    const std::vector<Field<Ends>> fields = {
        Field<Ends>{derived.name, &Ends::list, derived.meaning}.growing()};
    const auto ends = core::read_fields<Ends>(*table, fields, {}, known).list;
    if (ends.size() != 2)
      throw core::InvalidInput(
          fmt::format("{} must be two numbers, [low, high]", core::place(*table, derived.name)));
    bounds.push_back({&derived, ends[0], ends[1]});
  }
  return bounds;
}

press::Case case_of(const Table& base, const std::vector<Factor>& factors, const Point& point) {
  Table one = base;
  for (std::size_t i = 0; i < point.size(); ++i) set(one, factors[i].name, point[i]);
  return press::read_case(one);
}

/// Beside the card, else among the tables of the catalogue.
core::Csv read_table(const Table& card, const Table& design, const std::string& file) {
  const auto beside = std::filesystem::path(card.file).parent_path() / file;
  if (std::filesystem::is_regular_file(beside)) return core::read_csv(beside);
  for (const auto& catalogue : core::catalogues())
    if (const auto path = catalogue / "tables" / file; std::filesystem::is_regular_file(path))
      return core::read_csv(path);
  throw core::InvalidInput(
      fmt::format("{} = \"{}\": there is no such file beside the card, nor among the tables of the catalogue",
                  core::place(design, "file"), file));
}

Design read_design(const Table& table) {
  const Design design = core::read_fields<Design>(table, design_fields, {}, std::vector<std::string>{"only"});
  if (std::find(kinds.begin(), kinds.end(), design.kind) == kinds.end())
    throw core::InvalidInput(fmt::format("{} = \"{}\": there is no such design{}", core::place(table, "kind"),
                                         design.kind, core::suggestion(design.kind, kinds)));
  const bool random = design.kind == "latin-hypercube" || design.kind == "space-filling";
  const auto belongs = [&](const char* key, bool wanted, bool required) {
    const bool given = table.find(key);
    if (given && !wanted)
      throw core::InvalidInput(
          fmt::format("{} is not for a design of kind \"{}\"", core::place(table, key), design.kind));
    if (!given && required)
      throw core::InvalidInput(fmt::format("{}: [design] {} is missing; a design of kind \"{}\" needs it",
                                           table.file, key, design.kind));
  };
  belongs("runs", random, random);
  belongs("file", design.kind == "table", design.kind == "table");
  belongs("only", design.kind == "table", false);
  // A factorial design may have a seed, which is not used.
  return design;
}

std::vector<Factor> read_factors(const Table& card, const std::string& kind) {
  const Table& table = needed(card, "factors");
  std::vector<Factor> factors;
  for (const auto& [key, value] : table.entries) factors.push_back(read_factor(table, key, value, kind));
  if (factors.empty())
    throw core::InvalidInput(
        fmt::format("{}: the design is empty; give at least one factor in [factors]", card.file));
  if (kind == "space-filling") {
    const auto lists = std::count_if(factors.begin(), factors.end(),
                                     [](const Factor& factor) { return !factor.values.empty(); });
    if (lists > 1 || lists == static_cast<std::ptrdiff_t>(factors.size()))
      throw core::InvalidInput(
          fmt::format("{}: a space-filling design has ranges (min, max) and at most one factor with values",
                      core::place(card, "factors")));
  }
  return factors;
}

std::vector<Point> read_points(const Table& card, const Design& design, const std::vector<Factor>& factors,
                               const Table& base) {
  const auto bounds = read_bounds(card, design.kind);
  const auto runs = static_cast<std::size_t>(design.runs);
  const auto seed = static_cast<std::uint64_t>(design.seed);
  if (design.kind == "latin-hypercube") return latin_hypercube(factors, runs, seed);
  if (design.kind == "space-filling")
    return space_filling(factors, runs, seed, [&](const Point& point) {
      if (bounds.empty()) return true;
      const auto c = case_of(base, factors, point);
      return std::all_of(bounds.begin(), bounds.end(), [&](const Bound& bound) {
        const double x = bound.quantity->of(c);
        return x >= bound.low && x <= bound.high;
      });
    });
  if (design.kind == "table") {
    const Table& table = needed(card, "design");
    const Table* only = core::section(table, "only");
    return rows_of(read_table(card, table, design.file), factors,
                   only ? words(*only) : std::map<std::string, std::string>{});
  }
  double combinations = 1;
  for (const auto& factor : factors) combinations *= static_cast<double>(factor.values.size());
  constexpr double most = 1e6;
  if (combinations > most)
    throw core::InvalidInput(
        fmt::format("{}: the factors have {:.3g} combinations; a study may have {:.0f} runs",
                    place(card, "factors"), combinations, most));
  return factorial(factors);
}

/// "material.E_bar = 3, experiment = die".
std::string words_of(const std::vector<Factor>& factors, const Point& point) {
  std::string words;
  for (std::size_t i = 0; i < point.size(); ++i)
    words += fmt::format("{}{} = {}", i ? ", " : "", factors[i].name, text_of(point[i]));
  return words;
}

} // namespace

Study read_study(std::string_view path) {
  const Table card = core::read_toml(path);
  const Head head = core::read_fields<Head>(
      card, head_fields, {}, std::vector<std::string>{"case", "design", "factors", "bounds", "fit"});
  const Design design = read_design(needed(card, "design"));
  Study study{card.file,       head.name, design.kind, design.seed, read_factors(card, design.kind),
              read_laws(card), {}};
  const Table base = base_case(card);
  auto points = read_points(card, design, study.factors, base);
  if (points.empty())
    throw core::InvalidInput(fmt::format(
        "{}: the design is empty; its table has no row, or none that is as [design] only says", card.file));
  study.runs.resize(points.size());
  core::in_parallel(points.size(), [&](std::size_t i) {
    Run& run = study.runs[i];
    run.inputs = std::move(points[i]);
    try {
      run.press_case = case_of(base, study.factors, run.inputs);
    } catch (const core::InvalidInput& problem) {
      throw core::InvalidInput(fmt::format("{}: the run with {}: {}", card.file,
                                           words_of(study.factors, run.inputs), problem.what()));
    }
  });
  return study;
}

std::string study_reference() {
  std::string bounds;
  for (const auto& derived : derived_quantities())
    bounds += fmt::format("| `{}` | {} | two numbers, [low, high] |\n", derived.name, derived.meaning);
  return fmt::format(
      "# Study card\n\n{}"
      "| `case` | the base case | a path beside the study card, or a table |\n\n"
      "## [design]\n\n{}"
      "| `only` | of a table: the rows whose columns say so | a table of texts, {{ loading = \"die\" }} |\n\n"
      "## [factors]\n\n"
      "A key is `material.KEY` (of [parameters]), `path.KEY`, `mesh.KEY`, `radius_m`, `experiment` or "
      "`material`; its "
      "value a table. Levels that carry units go under the bare name: `\"material.E\" = {{ min = \"1 GPa\", "
      "max "
      "= \"5 GPa\" }}`, which is "
      "`material.E_Pa`.\n\n"
      "| key | meaning | value |\n|---|---|---|\n"
      "| `values` | the levels of a factorial design; shared out evenly in a random one | a list of numbers "
      "or "
      "texts |\n"
      "| `min`, `max` | range of a random design | numbers |\n"
      "| `scale` | whether the range is filled evenly in the number, or in its logarithm | \"linear\" or "
      "\"log\"; "
      "may be left out |\n"
      "| `column` | of a table; by default the one with the name of the factor | text; may be left out |\n"
      "| `names` | what the words of the column mean here | a table of texts, {{ hydro = \"hydrostatic\" }}; "
      "may be "
      "left out |\n\n"
      "## [bounds], of a space-filling design\n\n| key | meaning | value |\n|---|---|---|\n{}\n"
      "## [fit]\n\n| key | meaning | value |\n|---|---|---|\n"
      "| `laws` | laws that `platen study export` fits | a list of texts; known are edmans-sinka, agarwal, "
      "shahin |\n",
      core::reference_table(core::infos<Head>(head_fields)),
      core::reference_table(core::infos<Design>(design_fields)), bounds);
}

std::vector<Point> points_of(const Study& study) {
  std::vector<Point> points;
  for (const auto& run : study.runs) points.push_back(run.inputs);
  return points;
}

} // namespace platen::study
