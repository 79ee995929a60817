#include "press/case_card.hpp"

#include "core/catalogue.hpp"
#include "core/error.hpp"
#include "core/fields.hpp"
#include "core/nearest.hpp"
#include "core/number.hpp"
#include "material/card.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>

namespace platen::press {
namespace {

using core::closed, core::Field, core::left_open, core::positive;
using core::Table, core::Value;

constexpr double no_limit = std::numeric_limits<double>::infinity();

struct Head {
  int platen = 1;
  std::string experiment = "simple";
  double radius_m = 1e-3;
};
const std::vector<Field<Head>> head_fields = {
    {"platen", &Head::platen, "format of the card", closed(1, 1)},
    {"experiment", &Head::experiment,
     "simple: a sphere between two rigid planes; local: the same at small contacts, by force"},
    {"radius_m", &Head::radius_m, "radius of the undeformed particle", positive},
};

// delta_bar ends at 0.5, where the published simulations end (Edmans & Sinka, section 4).
const std::vector<Field<Case>> path_fields = {
    Field<Case>{"delta_bar_max", &Case::delta_bar_max, "largest delta/R0", left_open(0, 0.5)}.optional(),
    Field<Case>{"unload_from", &Case::unload_from, "delta/R0 from which a branch unloads", left_open(0, 0.5)}
        .optional()
        .growing(),
    Field<Case>{"reload", &Case::reload, "whether each unloaded branch is loaded again"}.optional(),
};
const std::vector<Field<Case>> mesh_fields = {
    Field<Case>{"elements", &Case::elements, "wanted number of elements; the mesh comes close to it",
                closed(32, 200000)}
        .optional(),
};
// Wang et al. 3.3: loads to 100 N.
const std::vector<Field<Case>> local_path_fields = {
    Field<Case>{"force_max_N", &Case::force_max_N,
                "largest force; not limited where delta_bar_max alone is given", positive}
        .optional(),
    Field<Case>{"unload_from_N", &Case::unload_from_N, "force from which a branch unloads", positive}
        .optional()
        .growing(),
    Field<Case>{"delta_bar_max", &Case::delta_bar_max, "largest delta/R0; loading ends where either is met",
                left_open(0, 0.5)}
        .optional(),
    Field<Case>{"unload_from", &Case::unload_from, "delta/R0 from which a branch unloads", left_open(0, 0.5)}
        .optional()
        .growing(),
    Field<Case>{"reload", &Case::reload, "whether each unloaded branch is loaded again"}.optional(),
};
const std::vector<Field<Case>> local_mesh_fields = {
    Field<Case>{"edges", &Case::edges, "of elements under the contact, at least", closed(8, 100)}.optional(),
    Field<Case>{"first_contact_bar", &Case::first_contact_bar,
                "contact radius/R0 from which on so many edges lie under it", closed(1e-4, 0.02)}
        .optional(),
};
const std::vector<Field<Case>> local_output_fields = {
    Field<Case>{"fields_at_N", &Case::fields_at_N, "force at which fields and the pressure profile are kept",
                positive}
        .optional()
        .growing(),
    Field<Case>{"fields_at", &Case::fields_at, "delta/R0 at which they are kept", left_open(0, 0.5)}
        .optional()
        .growing(),
};
const std::vector<Field<Case>> output_fields = {
    Field<Case>{"fields_at", &Case::fields_at, "delta/R0 at which fields are kept", left_open(0, 0.5)}
        .optional()
        .growing(),
};

const std::vector<std::string> experiments = {"simple", "local"};
const std::vector<std::string> later_experiments = {"die", "hydrostatic", "triaxial"};

void check_experiment(const std::string& experiment, const std::string& where) {
  if (std::find(experiments.begin(), experiments.end(), experiment) != experiments.end()) return;
  const std::string start = fmt::format("{} = \"{}\"", where, experiment);
  if (std::find(later_experiments.begin(), later_experiments.end(), experiment) != later_experiments.end())
    throw core::InvalidInput(fmt::format("{} is not available yet; available are: simple, local", start));
  throw core::InvalidInput(
      fmt::format("{}: there is no such experiment{}", start, core::suggestion(experiment, experiments)));
}

void check_within_path(const std::vector<double>& values, double end, const std::string& where,
                       std::string_view end_key = "delta_bar_max") {
  if (!values.empty() && values.back() > end)
    throw core::InvalidInput(fmt::format("{} goes to {}, beyond {} = {}", where,
                                         core::number_text(values.back()), end_key, core::number_text(end)));
}

/// The sections of a local case.
Case read_local(const Table& card, Case result) {
  const auto within_path = [&](const Table& section, const char* key, const std::vector<double>& overlaps,
                               const std::vector<double>& forces) {
    check_within_path(overlaps, result.delta_bar_max, core::place(section, key));
    check_within_path(forces, result.force_max_N, core::place(section, fmt::format("{}_N", key)),
                      "force_max_N");
  };
  if (const Table* path = core::section(card, "path")) {
    result = core::read_fields(*path, local_path_fields, result);
    if (path->find("delta_bar_max") && !path->find("force_max_N")) result.force_max_N = no_limit;
    within_path(*path, "unload_from", result.unload_from, result.unload_from_N);
  }
  if (const Table* mesh = core::section(card, "mesh"))
    result = core::read_fields(*mesh, local_mesh_fields, result);
  if (const Table* output = core::section(card, "output")) {
    result = core::read_fields(*output, local_output_fields, result);
    within_path(*output, "fields_at", result.fields_at, result.fields_at_N);
  }
  return result;
}

/// The path of a local case; a force that nobody asked for is not in it.
std::string local_path_lines(const Case& c) {
  std::string lines;
  for (const auto& field : local_path_fields)
    if (field.key != "force_max_N" || c.force_max_N < no_limit)
      lines += core::card_line(field.key, core::value_of(field, c));
  return lines;
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

} // namespace

Case read_case(std::string_view path) { return read_case(core::read_toml(path)); }

Case read_case(const Table& card) {
  const std::vector<std::string> others = {"material", "path", "mesh", "output"};
  const Head head = core::read_fields<Head>(card, head_fields, {}, others);
  check_experiment(head.experiment, core::place(card, "experiment"));

  Case result;
  result.experiment = head.experiment;
  result.radius_m = head.radius_m;
  if (head.experiment == "local") {
    result = read_local(card, result);
    result.material = read_material(card);
    return result;
  }
  if (const Table* path = core::section(card, "path")) {
    if (path->find("force_max_N"))
      throw core::InvalidInput(fmt::format("{} is for experiment = \"local\"; give delta_bar_max",
                                           core::place(*path, "force_max_N")));
    result = core::read_fields(*path, path_fields, result);
    check_within_path(result.unload_from, result.delta_bar_max, core::place(*path, "unload_from"));
  }
  if (const Table* mesh = core::section(card, "mesh")) result = core::read_fields(*mesh, mesh_fields, result);
  if (const Table* output = core::section(card, "output")) {
    result = core::read_fields(*output, output_fields, result);
    check_within_path(result.fields_at, result.delta_bar_max, core::place(*output, "fields_at"));
  }
  result.material = read_material(card);
  return result;
}

void validate(const Case& c) { (void)read_case(core::parse_toml(case_text(c), "case")); }

std::string case_text(const Case& c) {
  std::string material = material::card_text(c.material);
  const bool local = c.experiment == "local";
  const auto at = material.find("[parameters]");
  material.replace(at, std::string_view("[parameters]").size(), "[material.parameters]");
  return fmt::format("{}\n[path]\n{}\n[mesh]\n{}\n[output]\n{}\n[material]\n{}",
                     core::card_lines(head_fields, Head{1, c.experiment, c.radius_m}),
                     local ? local_path_lines(c) : core::card_lines(path_fields, c),
                     core::card_lines(local ? local_mesh_fields : mesh_fields, c),
                     core::card_lines(local ? local_output_fields : output_fields, c), material);
}

std::string case_reference() {
  const Case defaults;
  const auto page = [&](const std::vector<Field<Case>>& fields) {
    std::vector<core::FieldValue> values;
    for (const auto& field : fields) values.push_back(core::value_of(field, defaults));
    return core::reference_table(core::infos<Case>(fields), values);
  };
  return fmt::format(
      "# Case card\n\n{}| `material` | a name in the catalogue, a path, or a table | text or a "
      "table |\n\n## [path]\n\n{}\n## [mesh]\n\n{}\n## [output]\n\n{}"
      "\n# experiment = \"local\"\n\n## [path]\n\n{}\n## [mesh]\n\n{}\n## [output]\n\n{}",
      core::reference_table(core::infos<Head>(head_fields)), page(path_fields), page(mesh_fields),
      page(output_fields), page(local_path_fields), page(local_mesh_fields), page(local_output_fields));
}

} // namespace platen::press
