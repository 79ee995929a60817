#include "material/card.hpp"

#include "core/catalogue.hpp"
#include "core/error.hpp"
#include "core/fields.hpp"
#include "core/nearest.hpp"
#include "core/number.hpp"
#include "material/drucker_prager_card.hpp"
#include "material/hardening_card.hpp"
#include "material/mohr_coulomb_card.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

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
/// Of a hardening law that knows its yield stress.
const std::vector<Field<VonMises>> hardened_fields = {
    {"E_Pa", &VonMises::E, "Young's modulus", positive},
    {"nu", &VonMises::nu, "Poisson's ratio", right_open(0, 0.5)},
};

// Ranges at the reference density (Edmans & Sinka, section 3); their linear laws can leave them for
// nu and epsilon, as in two rows of their Table 4.
template <class M> std::vector<Field<M>> porous_fields() {
  return {
      {"rho_r0", &M::rho_r0, "relative density at which the values hold, and of the undeformed particle",
       left_open(0, 1)},
      {"sigma_y_Pa", &M::sigma_y, "hydrostatic yield stress in compression", positive},
      Field<M>{"E_Pa", &M::E, "Young's modulus", positive}.or_ratio("E_bar", "sigma_y_Pa"),
      {"nu", &M::nu, "Poisson's ratio", right_open(0, 0.5)},
      Field<M>{"Gamma_Pa", &M::Gamma, "shear strength, largest q", positive}.or_ratio("Gamma_bar",
                                                                                      "sigma_y_Pa"),
      Field<M>{"Lambda_Pa", &M::Lambda, "tensile strength, largest p", positive}.or_ratio("Lambda_bar",
                                                                                          "sigma_y_Pa"),
      {"epsilon", &M::epsilon, "compaction cap: semi-axis along p over semi-axis along q", positive},
      {"eta", &M::eta, "exponent of sigma_y over relative density", any_number},
      {"xi", &M::xi, "exponent of E", any_number},
      {"zeta", &M::zeta, "exponent of Gamma", any_number},
      {"omega", &M::omega, "exponent of Lambda", any_number},
      {"xi_1", &M::xi_1, "slope of nu over relative density", any_number},
      {"xi_2", &M::xi_2, "slope of epsilon over relative density", any_number},
  };
}
const std::vector<Field<Vmdc>> vmdc_fields = porous_fields<Vmdc>();
const std::vector<Field<Dpc>> dpc_fields = [] {
  auto fields = porous_fields<Dpc>();
  fields.push_back(Field<Dpc>{"published_flow", &Dpc::published_flow,
                              "the paper's potential, whose plastic power can be negative"}
                       .optional());
  return fields;
}();

/// What any material may say beside its model; 0: not given.
struct Beside {
  double tensile_strength = 0, density = 0;
};
const std::vector<Field<Beside>> beside_fields = {
    Field<Beside>{"tensile_strength_Pa", &Beside::tensile_strength,
                  "any model: a press says where the largest principal stress reaches it", positive}
        .optional(),
    Field<Beside>{"density_kg_per_m3", &Beside::density,
                  "any model: mass density of the undeformed particle, for exports alone", positive}
        .optional(),
};
const std::vector<std::string> beside_keys = {"tensile_strength_Pa", "density_kg_per_m3"};

void read_beside(const Table& parameters, Material& material) {
  std::vector<std::string> others; // the model's own, already read
  for (const auto& entry : parameters.entries) others.push_back(entry.key);
  const Beside beside = core::read_fields<Beside>(parameters, beside_fields, {}, others);
  if (beside.tensile_strength > 0) material.tensile_strength = beside.tensile_strength;
  if (beside.density > 0) material.density = beside.density;
}

/// What a material says beside its model.
std::vector<Parameter> beside(const Material& material) {
  std::vector<Parameter> list;
  const auto add = [&](std::size_t i, const std::optional<double>& value) {
    if (value) list.push_back({beside_fields[i].key, *value, beside_fields[i].meaning});
  };
  add(0, material.tensile_strength);
  add(1, material.density);
  return list;
}

/// The fields of the model's own type, handed to `use`.
template <class Use> decltype(auto) with_fields(const Model& model, Use use) {
  struct Choose {
    Use& use_;
    auto operator()(const Elastic& m) { return use_(elastic_fields, m); }
    auto operator()(const VonMises& m) {
      return use_(has_own_yield_stress(m.hardening) ? hardened_fields : von_mises_fields, m);
    }
    auto operator()(const Vmdc& m) { return use_(vmdc_fields, m); }
    auto operator()(const DruckerPrager& m) { return use_(drucker_prager_fields(), m); }
    auto operator()(const Dpc& m) { return use_(dpc_fields, m); }
    auto operator()(const MohrCoulomb& m) { return use_(mohr_coulomb_fields(), m); }
  };
  return std::visit(Choose{use}, model);
}

VonMises read_von_mises(const Table& table) {
  VonMises m{};
  m.hardening = read_hardening(table);
  const bool own = has_own_yield_stress(m.hardening);
  for (const char* key : {"sigma_y_Pa", "E_bar"})
    if (own && table.find(key))
      throw core::InvalidInput(
          fmt::format("{}: this hardening has its own yield stress; leave it out, and give E_Pa",
                      core::place(table, key)));
  std::vector<std::string> others = beside_keys;
  others.push_back("hardening");
  m = core::read_fields(table, own ? hardened_fields : von_mises_fields, m, others);
  m.sigma_y = initial_yield_stress(m.hardening, m.E, m.sigma_y);
  check_hardening(table, m.hardening, m.E, m.moduli(0).G, m.sigma_y);
  return m;
}

Dpc read_dpc(const Table& table) {
  const Dpc m = core::read_fields(table, dpc_fields, {}, beside_keys);
  if (m.epsilon * m.Gamma >= m.sigma_y)
    throw core::InvalidInput(fmt::format(
        "{}: the cap would begin inside the failure line; epsilon Gamma = {} must be less than sigma_y = {}",
        core::place(table, "epsilon"), core::number_text(m.epsilon * m.Gamma), core::number_text(m.sigma_y)));
  return m;
}

struct Head {
  int platen = 1;
  std::string name, model;
};
const std::vector<Field<Head>> head_fields = {
    {"platen", &Head::platen, "format of the card", closed(1, 1)},
    {"name", &Head::name, "name of the material, for people"},
    {"model", &Head::model, "elastic, von-mises, vmdc, dpc, drucker-prager or mohr-coulomb"},
};
const std::vector<std::string> sections = {"parameters", "source"};

Model read_model(const Table& card, const std::string& name, const Table& table) {
  if (name == "elastic") return core::read_fields(table, elastic_fields, {}, beside_keys);
  if (name == "von-mises") return read_von_mises(table);
  if (name == "vmdc") return core::read_fields(table, vmdc_fields, {}, beside_keys);
  if (name == "drucker-prager") return read_drucker_prager(table, beside_keys);
  if (name == "dpc") return read_dpc(table);
  if (name == "mohr-coulomb") return read_mohr_coulomb(table, beside_keys);
  const std::vector<std::string> names(model_names.begin(), model_names.end());
  throw core::InvalidInput(fmt::format("{} = \"{}\": there is no such model{}", core::place(card, "model"),
                                       name, core::suggestion(name, names)));
}

const Table& needed_section(const Table& card, std::string_view name) {
  const Table* table = core::section(card, name);
  if (!table)
    throw core::InvalidInput(fmt::format("{}: the section [{}] is missing", core::place(card, name), name));
  return *table;
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
  Card card{{head.name, read_model(table, head.model, parameter_table), {}}, {}, table.file};
  read_beside(parameter_table, card.material);
  if (const Table* source = core::section(table, "source"))
    card.sources = read_sources(*source, parameter_table);
  return card;
}

std::string card_text(const Material& material) {
  const Head head{1, material.name, std::string(model_name(material.model))};
  auto lines = with_fields(
      material.model, [](const auto& fields, const auto& model) { return core::card_lines(fields, model); });
  if (const auto* metal = std::get_if<VonMises>(&material.model)) lines += hardening_line(metal->hardening);
  for (const auto& parameter : beside(material)) lines += core::card_line(parameter.key, parameter.value);
  return fmt::format("{}\n[parameters]\n{}", core::card_lines(head_fields, head), lines);
}

std::vector<Parameter> parameters(const Material& material) {
  auto list = parameters(material.model);
  std::ranges::move(beside(material), std::back_inserter(list));
  return list;
}

std::vector<Parameter> parameters(const Model& model) {
  std::vector<Parameter> list = with_fields(model, [](const auto& fields, const auto& m) {
    std::vector<Parameter> values;
    for (const auto& field : fields) {
      const core::FieldValue value = core::value_of(field, m);
      const auto* choice = std::get_if<bool>(&value);
      values.push_back({field.key, choice ? *choice : std::get<double>(value), field.meaning});
    }
    return values;
  });
  if (const auto* metal = std::get_if<VonMises>(&model))
    for (const auto& [key, number] : hardening_numbers(metal->hardening))
      list.push_back({key, number.first, number.second});
  return list;
}

std::string card_reference() {
  std::string page = "# Material card\n\n" + core::reference_table(core::infos<Head>(head_fields));
  const auto section = [&](const char* model, const std::vector<core::FieldInfo>& fields) {
    page += fmt::format("\n## [parameters] of model = \"{}\"\n\n{}", model, core::reference_table(fields));
  };
  section("elastic", core::infos<Elastic>(elastic_fields));
  section("von-mises", core::infos<VonMises>(von_mises_fields));
  page += hardening_reference();
  section("vmdc", core::infos<Vmdc>(vmdc_fields));
  section("dpc", core::infos<Dpc>(dpc_fields));
  page += "\nepsilon Gamma must be less than sigma_y.\n";
  section("drucker-prager", drucker_prager_infos());
  page += "\nExactly one of beta_deg + sigma_c_Pa, phi_deg + sigma_c_Pa, phi_deg + cohesion_Pa.\n";
  section("mohr-coulomb", mohr_coulomb_infos());
  page += "\nExactly one of cohesion_Pa and sigma_c_Pa.\n";
  page += "\n## [parameters] beside those of the model\n\n" +
          core::reference_table(core::infos<Beside>(beside_fields));
  page += "\n## [source]\n\nText for any key above, or `default`: where its value is from.\n";
  return page;
}

} // namespace platen::material
