#include "material/card.hpp"

#include "core/catalogue.hpp"
#include "core/error.hpp"
#include "core/nearest.hpp"

#include <fmt/format.h>

namespace platen::material {
namespace {

using core::Field, core::positive, core::Table;

/// What any material may say beside its model.
const std::vector<Field<Material>> beside_fields = {
    {"tensile_strength_Pa", &Material::tensile_strength,
     "any model: a press says where the largest principal stress reaches it", positive},
    {"density_kg_per_m3", &Material::density,
     "any model: mass density of the undeformed particle, for exports alone", positive},
};

std::vector<std::string> keys_of(const Table& table) {
  std::vector<std::string> keys;
  keys.reserve(table.entries.size());
  for (const auto& entry : table.entries) keys.push_back(entry.key);
  return keys;
}

std::vector<std::string> model_names() {
  std::vector<std::string> names;
  for_each_model([&]<class M>() { names.emplace_back(M::name); });
  return names;
}

struct Head {
  int platen = 1;
  std::string name, model;
};
const std::vector<Field<Head>>& head_fields() {
  static const auto fields = [] {
    auto names = model_names();
    const std::string last = names.back();
    names.pop_back();
    return std::vector<Field<Head>>{
        {"platen", &Head::platen, "format of the card", core::closed(1, 1)},
        {"name", &Head::name, "name of the material, for people"},
        {"model", &Head::model, fmt::format("{} or {}", fmt::join(names, ", "), last)},
    };
  }();
  return fields;
}
const std::vector<std::string> sections = {"parameters", "source"};

Model read_model(const Table& card, const std::string& name, const Table& table) {
  static const std::vector<std::string> beside_keys = [] {
    std::vector<std::string> keys;
    for (const auto& field : beside_fields) keys.push_back(field.key);
    return keys;
  }();
  Model model;
  bool known = false;
  for_each_model([&]<class M>() {
    if (name != M::name) return;
    model = M::card().read(table, beside_keys);
    known = true;
  });
  if (!known)
    throw core::InvalidInput(fmt::format("{} = \"{}\": there is no such model{}", core::place(card, "model"),
                                         name, core::suggestion(name, model_names())));
  return model;
}

std::vector<CardEntry> entries_of(const Model& model) {
  return std::visit([]<class M>(const M& m) { return M::card().entries(m); }, model);
}

const Table& needed_section(const Table& card, std::string_view name) {
  const Table* table = core::section(card, name);
  if (!table)
    throw core::InvalidInput(fmt::format("{}: the section [{}] is missing", core::place(card, name), name));
  return *table;
}

std::vector<std::pair<std::string, std::string>> read_sources(const Table& table,
                                                              const Table& parameter_table) {
  std::vector<std::string> known = keys_of(parameter_table);
  known.insert(known.begin(), "default");
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
  const Head head = core::read_fields<Head>(table, head_fields(), {}, sections);
  const Table& parameter_table = needed_section(table, "parameters");
  const Material material{head.name, read_model(table, head.model, parameter_table)};
  Card card{
      core::read_fields(parameter_table, beside_fields, material, keys_of(parameter_table)), {}, table.file};
  if (const Table* source = core::section(table, "source"))
    card.sources = read_sources(*source, parameter_table);
  return card;
}

std::string card_text(const Material& material) {
  const Head head{1, material.name, std::string(model_name(material.model))};
  return fmt::format("{}\n[parameters]\n{}{}", core::card_lines(head_fields(), head),
                     card_lines(entries_of(material.model)), core::card_lines(beside_fields, material));
}

std::vector<Parameter> parameters(const Model& model) { return parameters(entries_of(model)); }

std::vector<Parameter> parameters(const Material& material) {
  auto entries = entries_of(material.model);
  for (auto& entry : entries_of(beside_fields, material)) entries.push_back(std::move(entry));
  return parameters(entries);
}

std::string card_reference() {
  std::string page = "# Material card\n\n" + core::reference_table(core::infos<Head>(head_fields()));
  for_each_model([&]<class M>() {
    const auto& card = M::card();
    page +=
        fmt::format("\n## [parameters] of model = \"{}\"\n\n{}", M::name, core::reference_table(card.fields));
    if (!card.note.empty()) page += "\n" + card.note;
  });
  page += "\n## [parameters] beside those of the model\n\n" +
          core::reference_table(core::infos<Material>(beside_fields));
  page += "\n## [source]\n\nText for any key above, or `default`: where its value is from.\n";
  return page;
}

} // namespace platen::material
