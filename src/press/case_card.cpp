#include "press/case_card.hpp"

#include "core/catalogue.hpp"
#include "core/error.hpp"
#include "core/nearest.hpp"
#include "core/number.hpp"
#include "core/unit.hpp"
#include "material/card.hpp"
#include "press/card_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <type_traits>
#include <utility>

namespace platen::press {
namespace {

using core::Field, core::Table, core::Value;

struct Head {
  int platen = 1;
  std::string experiment = "simple";
  double radius_m = 1e-3;
};
const std::vector<Field<Head>> head_fields = {
    {"platen", &Head::platen, "format of the card", core::closed(1, 1)},
    {"experiment", &Head::experiment,
     "simple: a sphere between two rigid planes; local: the same at small contacts, by force; die: between "
     "two planes and four walls; hydrostatic: between six planes; triaxial: between planes that go their own "
     "ways"},
    {"radius_m", &Head::radius_m, "radius of the undeformed particle", core::positive},
};

/// A default experiment of each type, in the order of the variant.
const std::vector<Experiment>& experiments() {
  static const std::vector<Experiment> all = []<std::size_t... i>(std::index_sequence<i...>) {
    return std::vector<Experiment>{std::variant_alternative_t<i, Experiment>{}...};
  }
  (std::make_index_sequence<std::variant_size_v<Experiment>>());
  return all;
}

Experiment experiment_named(const std::string& name, const Table& card) {
  std::vector<std::string> names;
  for (const Experiment& e : experiments()) {
    if (name_of(e) == name) return e;
    names.emplace_back(name_of(e));
  }
  throw core::InvalidInput(fmt::format("{} = \"{}\": there is no such experiment{}",
                                       core::place(card, "experiment"), name, core::suggestion(name, names)));
}

/// What is looked at before the fields are read.
const std::vector<std::string> limits_by_force = {"force_max_N"};

template <class X> X read_sections(const Table& card, X e) {
  const CardFields<X>& fields = card_fields(&e);
  const Table* written = core::section(card, "path");
  const auto converted = written ? core::in_si(*written, limits_by_force) : std::nullopt;
  const Table* path = converted ? &*converted : written;
  if constexpr (!std::is_same_v<X, Local>)
    if (path && path->find("force_max_N"))
      throw core::InvalidInput(fmt::format("{} is for experiment = \"local\"; give {}",
                                           core::place(*path, "force_max_N"), fields.path.front().key));
  const bool needed =
      std::any_of(fields.path.begin(), fields.path.end(), [](const auto& field) { return field.required; });
  if (needed && !path)
    throw core::InvalidInput(
        fmt::format("{}: a {} press needs [path] {}", card.file, X::name, fields.path.front().key));
  if (path) e = core::read_fields(*path, fields.path, e);
  if (const Table* mesh = core::section(card, "mesh")) e = core::read_fields(*mesh, fields.mesh, e);
  if (const Table* output = core::section(card, "output")) e = core::read_fields(*output, fields.output, e);
  if constexpr (std::is_same_v<X, Local>)
    if (path && path->find("delta_bar_max") && !path->find("force_max_N"))
      e.force_max_N = std::numeric_limits<double>::infinity();
  return e;
}

std::filesystem::path find_material(const Table& card, const std::string& what) {
  // A card and the material beside it can be moved together.
  const auto beside = std::filesystem::path(card.file).parent_path() / what;
  std::error_code error;
  if (std::filesystem::is_regular_file(beside, error)) return beside;
  try {
    return core::find_card("materials", what);
  } catch (const core::InvalidInput& problem) {
    throw core::InvalidInput(fmt::format("{}: {}", core::place(card, "material"), problem.what()));
  }
}

material::Material read_material(const Table& card) {
  const Value* value = card.find("material");
  if (!value)
    throw core::InvalidInput(
        fmt::format("{}: material is missing: a name in the catalogue, a path, or a table", card.file));
  if (const auto* table = std::get_if<Table>(&value->data)) return material::read_card(*table).material;
  const auto* what = std::get_if<std::string>(&value->data);
  if (!what)
    throw core::InvalidInput(
        fmt::format("{} = {} is {}; it must be a name in the catalogue, a path, or a table",
                    core::place(card, "material"), core::text_of(*value), core::kind_of(*value)));
  return material::read_card(core::read_toml(find_material(card, *what))).material;
}

/// A force that nobody asked for.
bool is_no_limit(const core::FieldValue& value) {
  const auto* number = std::get_if<double>(&value);
  return number && *number == std::numeric_limits<double>::infinity();
}

/// Lines of a section; a limit that nobody asked for, infinity, is not in it. Without defaults all lines,
/// else those that differ from them.
template <class X>
std::string lines_of(const std::vector<Field<X>>& fields, const X& e, const X* defaults = nullptr) {
  std::string lines;
  for (const auto& field : fields) {
    const core::FieldValue value = core::value_of(field, e);
    if (!defaults && is_no_limit(value)) continue;
    if (defaults && core::value_of(field, *defaults) == value) continue;
    lines += core::card_line(field.key, value);
  }
  return lines;
}

template <class X>
void check_fields(const std::vector<Field<X>>& fields, const X& e, std::string_view section) {
  for (const auto& field : fields) {
    const core::FieldValue value = core::value_of(field, e);
    if (field.key == "force_max_N" && is_no_limit(value)) continue;
    core::check_value(field, value, section);
  }
}

/// Forces and work, R^2 sigma and R^3 sigma, have to be numbers.
void check_size(const Case& c, const Table* card) {
  const double sigma = material::reference_stress(c.material.model);
  if (std::isnormal(std::pow(c.radius_m, 2) * sigma) && std::isnormal(std::pow(c.radius_m, 3) * sigma))
    return;
  throw core::InvalidInput(fmt::format("{} = {}: forces of a particle of this size are no numbers",
                                       card ? core::place(*card, "radius_m") : "radius_m",
                                       core::number_text(c.radius_m)));
}

} // namespace

Case read_case(std::string_view path) { return read_case(core::read_toml(path)); }

Case read_case(const Table& card) {
  static const std::vector<std::string> others = {"material", "path", "mesh", "output"};
  const Head head = core::read_fields(card, head_fields, Head{}, others);
  Case c;
  c.radius_m = head.radius_m;
  c.experiment = std::visit([&](const auto& e) { return Experiment(read_sections(card, e)); },
                            experiment_named(head.experiment, card));
  c.material = read_material(card);
  check_size(c, &card);
  const Places at{core::section(card, "path"), core::section(card, "output")};
  std::visit([&](const auto& e) { check(e, c.material, at); }, c.experiment);
  return c;
}

void validate(const Case& c) {
  check_fields(head_fields, Head{1, std::string(name_of(c.experiment)), c.radius_m}, "");
  check_size(c, nullptr);
  std::visit(
      [&](const auto& e) {
        const auto& fields = card_fields(&e);
        check_fields(fields.path, e, "path");
        check_fields(fields.mesh, e, "mesh");
        check_fields(fields.output, e, "output");
        check(e, c.material, {});
      },
      c.experiment);
}

namespace {
std::string text(const Case& c, bool defaults_too) {
  std::string material = material::card_text(c.material);
  const auto at = material.find("[parameters]");
  material.replace(at, std::string_view("[parameters]").size(), "[material.parameters]");
  return std::visit(
      [&]<class X>(const X& e) {
        const CardFields<X>& fields = card_fields(&e);
        const X plain{};
        const X* leave_out = defaults_too ? nullptr : &plain;
        return fmt::format("{}\n[path]\n{}\n[mesh]\n{}\n[output]\n{}\n[material]\n{}",
                           core::card_lines(head_fields, Head{1, std::string(X::name), c.radius_m}),
                           lines_of(fields.path, e, leave_out), lines_of(fields.mesh, e, leave_out),
                           lines_of(fields.output, e, leave_out), material);
      },
      c.experiment);
}
} // namespace

std::string case_text(const Case& c) { return text(c, true); }
std::string case_identity(const Case& c) { return text(c, false); }

std::string case_reference() {
  const auto page = []<class X>(const std::vector<Field<X>>& fields) {
    const X defaults{};
    std::vector<core::FieldValue> values;
    for (const auto& field : fields) values.push_back(core::value_of(field, defaults));
    return core::reference_table(core::infos<X>(fields), values);
  };
  std::string text =
      fmt::format("# Case card\n\n{}| `material` | a name in the catalogue, a path, or a table | text "
                  "or a table |\n",
                  core::reference_table(core::infos<Head>(head_fields)));
  for (const Experiment& any : experiments())
    std::visit(
        [&]<class X>(const X& e) {
          const CardFields<X>& fields = card_fields(&e);
          text +=
              fmt::format("\n# experiment = \"{}\"\n\n## [path]\n\n{}\n## [mesh]\n\n{}\n## [output]\n\n{}",
                          X::name, page(fields.path), page(fields.mesh), page(fields.output));
        },
        any);
  return text;
}

std::string_view name_of(const Experiment& experiment) {
  return std::visit([](const auto& e) { return e.name; }, experiment);
}

const ByOverlap* by_overlap(const Experiment& experiment) {
  return std::visit(
      []<class X>(const X& e) -> const ByOverlap* {
        if constexpr (std::is_base_of_v<ByOverlap, X>) return &e;
        else return nullptr;
      },
      experiment);
}
ByOverlap* by_overlap(Experiment& experiment) {
  return const_cast<ByOverlap*>(by_overlap(std::as_const(experiment)));
}

std::string Places::path(std::string_view key) const {
  return path_section ? core::place(*path_section, key) : fmt::format("[path] {}", key);
}
std::string Places::path(std::string_view key, double value) const {
  return fmt::format("{} = {}", path(key), core::number_text(value));
}
std::string Places::output(std::string_view key) const {
  return output_section ? core::place(*output_section, key) : fmt::format("[output] {}", key);
}

void check_within(const std::vector<double>& values, double end, const std::string& place,
                  std::string_view end_key) {
  if (!values.empty() && values.back() > end)
    throw core::InvalidInput(fmt::format("{} goes to {}, beyond {} = {}", place,
                                         core::number_text(values.back()), end_key, core::number_text(end)));
}

void check_path(const ByOverlap& e, const Places& at, double resolved) {
  if (e.delta_bar_max < resolved)
    throw core::InvalidInput(fmt::format(
        "{} is a contact smaller than this mesh resolves, {} at least; experiment = \"local\" presses it",
        at.path("delta_bar_max", e.delta_bar_max), core::number_text(resolved)));
  check_within(e.unload_from, e.delta_bar_max, at.path("unload_from"));
  check_within(e.fields_at, e.delta_bar_max, at.output("fields_at"));
}

Halts halts_of(const ByOverlap& e) {
  return {.end = e.delta_bar_max, .unload_from = e.unload_from, .fields_at = e.fields_at, .reload = e.reload};
}

} // namespace platen::press
