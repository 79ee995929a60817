#include "app/commands.hpp"
#include "core/catalogue.hpp"
#include "core/number.hpp"
#include "core/version.hpp"
#include "material/card.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace platen::app {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string name;
  bool json = false, keys = false;
};

Json json_of(const material::Card& card) {
  Json object = {{"platen", core::version},
                 {"name", card.material.name},
                 {"model", material::model_name(card.material.model)},
                 {"file", card.file}};
  for (const auto& parameter : material::parameters(card.material))
    object["parameters"][parameter.key] = parameter.value;
  for (const auto& [key, source] : card.sources) object["source"][key] = source;
  return object;
}

void print_card(const material::Card& card) {
  fmt::print("{}: model {}, from {}\n\n", card.material.name, material::model_name(card.material.model),
             card.file);
  for (const auto& parameter : material::parameters(card.material))
    fmt::print("  {:<12} {:<12} {}\n", parameter.key, core::number_text(parameter.value), parameter.meaning);
  for (const auto& [key, source] : card.sources) fmt::print("\n  source ({}): {}", key, source);
  if (!card.sources.empty()) fmt::print("\n");
}

void list_cards(bool as_json) {
  Json list = Json::array();
  for (const auto& name : core::card_names("materials")) {
    const auto card = material::read_card(name);
    const auto model = material::model_name(card.material.model);
    if (as_json) list.push_back({{"card", name}, {"name", card.material.name}, {"model", model}});
    else fmt::print("{:<18} {:<10} {}\n", name, model, card.material.name);
  }
  if (as_json) fmt::print("{}\n", list.dump(2));
}

void materials(const Options& options) {
  if (options.keys) fmt::print("{}", material::card_reference());
  else if (options.name.empty()) list_cards(options.json);
  else if (const auto card = material::read_card(options.name); options.json)
    fmt::print("{}\n", json_of(card).dump(2, ' ', false, Json::error_handler_t::replace));
  else print_card(card);
}

} // namespace

void add_materials(Command program) {
  auto command =
      program.add_subcommand("materials", "list the material cards of the catalogue, or print one");
  auto options = std::make_shared<Options>();
  command.add_option("NAME", options->name, "name in the catalogue, or path of a card");
  command.add_flag("--json", options->json, "for a machine to read");
  command.add_flag("--keys", options->keys, "every key of a material card, as Markdown");
  command.footer("Example: platen materials mcc-ph-200");
  command.callback([options] { materials(*options); });
}

} // namespace platen::app
