#include "material/card.hpp"

#include "core/catalogue.hpp"
#include "core/error.hpp"
#include "core/fields.hpp"
#include "core/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace platen::material {
namespace {

using core::any_number, core::closed, core::left_open, core::positive, core::right_open;
using core::Field, core::Table, core::Value;

const std::vector<Field<Elastic>> elastic_fields = {
    {"E_Pa", &Elastic::E, "Young's modulus", positive},
    {"nu", &Elastic::nu, "Poisson's ratio", right_open(0, 0.5)},
};

const std::vector<Field<VonMises>> von_mises_fields = {
    {"sigma_y_Pa", &VonMises::sigma_y, "uniaxial yield stress", positive},
    Field<VonMises>{"E_Pa", &VonMises::E, "Young's modulus", positive}.or_ratio("E_bar", "sigma_y_Pa"),
    {"nu", &VonMises::nu, "Poisson's ratio", right_open(0, 0.5)},
};

// Ranges at the reference density (Edmans & Sinka, section 3); their linear laws can leave them for
// nu and epsilon, as in two rows of their Table 4.
const std::vector<Field<Vmdc>> vmdc_fields = {
    {"rho_r0", &Vmdc::rho_r0, "relative density at which the values hold, and of the undeformed particle",
     left_open(0, 1)},
    {"sigma_y_Pa", &Vmdc::sigma_y, "hydrostatic yield stress in compression", positive},
    Field<Vmdc>{"E_Pa", &Vmdc::E, "Young's modulus", positive}.or_ratio("E_bar", "sigma_y_Pa"),
    {"nu", &Vmdc::nu, "Poisson's ratio", right_open(0, 0.5)},
    Field<Vmdc>{"Gamma_Pa", &Vmdc::Gamma, "shear strength, largest q", positive}.or_ratio("Gamma_bar",
                                                                                          "sigma_y_Pa"),
    Field<Vmdc>{"Lambda_Pa", &Vmdc::Lambda, "tensile strength, largest p", positive}.or_ratio("Lambda_bar",
                                                                                              "sigma_y_Pa"),
    {"epsilon", &Vmdc::epsilon, "compaction cap: semi-axis along p over semi-axis along q", positive},
    {"eta", &Vmdc::eta, "exponent of sigma_y over relative density", any_number},
    {"xi", &Vmdc::xi, "exponent of E", any_number},
    {"zeta", &Vmdc::zeta, "exponent of Gamma", any_number},
    {"omega", &Vmdc::omega, "exponent of Lambda", any_number},
    {"xi_1", &Vmdc::xi_1, "slope of nu over relative density", any_number},
    {"xi_2", &Vmdc::xi_2, "slope of epsilon over relative density", any_number},
};

/// What any material may say beside its model.
struct Beside {
  double tensile_strength = 0; ///< 0: not given
};
const std::vector<Field<Beside>> beside_fields = {
    Field<Beside>{"tensile_strength_Pa", &Beside::tensile_strength,
                  "any model: a press says where the largest principal stress reaches it", positive}
        .optional(),
};
const std::vector<std::string> beside_keys = {"tensile_strength_Pa"};

std::optional<double> read_tensile_strength(const Table& parameters) {
  std::vector<std::string> others; // the model's own, already read
  for (const auto& entry : parameters.entries) others.push_back(entry.key);
  const double strength = core::read_fields<Beside>(parameters, beside_fields, {}, others).tensile_strength;
  return strength > 0 ? std::optional(strength) : std::nullopt;
}

/// The fields of the model's own type, handed to `use`.
template <class Use> decltype(auto) with_fields(const Model& model, Use use) {
  struct Choose {
    Use& use_;
    auto operator()(const Elastic& m) { return use_(elastic_fields, m); }
    auto operator()(const VonMises& m) { return use_(von_mises_fields, m); }
    auto operator()(const Vmdc& m) { return use_(vmdc_fields, m); }
  };
  return std::visit(Choose{use}, model);
}

const std::vector<std::string> model_names = {"elastic", "von-mises", "vmdc"};
const std::vector<std::string> later_models = {"dpc", "drucker-prager", "mohr-coulomb"};
const std::vector<std::string> later_parameters = {"hardening", "density_kg_per_m3"};

struct Head {
  int platen = 1;
  std::string name, model;
};
const std::vector<Field<Head>> head_fields = {
    {"platen", &Head::platen, "format of the card", closed(1, 1)},
    {"name", &Head::name, "name of the material, for people"},
    {"model", &Head::model, "elastic, von-mises or vmdc"},
};
const std::vector<std::string> sections = {"parameters", "source"};

Model empty_model(const Table& card, const std::string& name) {
  if (name == "elastic") return Elastic{};
  if (name == "von-mises") return VonMises{};
  if (name == "vmdc") return Vmdc{};
  const std::string start = fmt::format("{} = \"{}\"", core::place(card, "model"), name);
  if (std::find(later_models.begin(), later_models.end(), name) != later_models.end())
    throw core::InvalidInput(
        fmt::format("{} is not available yet; available are: {}", start, fmt::join(model_names, ", ")));
  throw core::InvalidInput(
      fmt::format("{}: there is no such model{}", start, core::suggestion(name, model_names)));
}

const Table& needed_section(const Table& card, std::string_view name) {
  const Table* table = core::section(card, name);
  if (!table)
    throw core::InvalidInput(fmt::format("{}: the section [{}] is missing", core::place(card, name), name));
  return *table;
}

void refuse_later_parameters(const Table& table) {
  for (const auto& key : later_parameters)
    if (table.find(key))
      throw core::InvalidInput(
          fmt::format("{} is not available yet; leave it out{}", core::place(table, key),
                      key == "hardening" ? ", the material is then perfectly plastic" : ""));
}

std::vector<std::pair<std::string, std::string>> read_sources(const Table& table,
                                                              const Table& parameter_table) {
  std::vector<std::string> known = {"default"};
  for (const auto& entry : parameter_table.entries) known.push_back(entry.key);
  core::refuse_unknown_keys(table, known);
  std::vector<std::pair<std::string, std::string>> sources;
  for (const auto& [key, value] : table.entries) {
    const auto* text = std::get_if<std::string>(&value.data);
    if (!text)
      throw core::InvalidInput(fmt::format("{} = {} is {}; it must be text", core::place(table, key),
                                           core::text_of(value), core::kind_of(value)));
    sources.emplace_back(key, *text);
  }
  return sources;
}

} // namespace

Card read_card(std::string_view what) {
  return read_card(core::read_toml(core::find_card("materials", what)));
}

Card read_card(const Table& table) {
  const Head head = core::read_fields<Head>(table, head_fields, {}, sections);
  const Table& parameter_table = needed_section(table, "parameters");
  Card card{{head.name, empty_model(table, head.model), {}}, {}, table.file};
  refuse_later_parameters(parameter_table);
  card.material.model = with_fields(card.material.model, [&](const auto& fields, const auto& empty) -> Model {
    return core::read_fields(parameter_table, fields, empty, beside_keys);
  });
  card.material.tensile_strength = read_tensile_strength(parameter_table);
  if (const Table* source = core::section(table, "source"))
    card.sources = read_sources(*source, parameter_table);
  return card;
}

std::string card_text(const Material& material) {
  const Head head{1, material.name, std::string(model_name(material.model))};
  const auto lines = with_fields(
      material.model, [](const auto& fields, const auto& model) { return core::card_lines(fields, model); });
  const auto strength = material.tensile_strength;
  return fmt::format("{}\n[parameters]\n{}{}", core::card_lines(head_fields, head), lines,
                     strength ? core::card_line(beside_keys[0], *strength) : "");
}

std::string_view model_name(const Model& model) { return model_names[model.index()]; }

std::vector<Parameter> parameters(const Material& material) {
  auto list = parameters(material.model);
  if (const auto strength = material.tensile_strength)
    list.push_back({beside_fields[0].key, *strength, beside_fields[0].meaning});
  return list;
}

std::vector<Parameter> parameters(const Model& model) {
  return with_fields(model, [](const auto& fields, const auto& m) {
    std::vector<Parameter> list;
    for (const auto& field : fields)
      list.push_back({field.key, std::get<double>(core::value_of(field, m)), field.meaning});
    return list;
  });
}

std::string card_reference() {
  std::string page = "# Material card\n\n" + core::reference_table(core::infos<Head>(head_fields));
  page += "\n## [parameters] of model = \"elastic\"\n\n" +
          core::reference_table(core::infos<Elastic>(elastic_fields));
  page += "\n## [parameters] of model = \"von-mises\"\n\n" +
          core::reference_table(core::infos<VonMises>(von_mises_fields));
  page += "\n## [parameters] of model = \"vmdc\"\n\n" + core::reference_table(core::infos<Vmdc>(vmdc_fields));
  page += "\n## [parameters] beside those of the model\n\n" +
          core::reference_table(core::infos<Beside>(beside_fields));
  page += "\n## [source]\n\nText for any key above, or `default`: where its value is from.\n";
  return page;
}

} // namespace platen::material
