#include "fit/law_card.hpp"

#include "core/catalogue.hpp"
#include "core/error.hpp"
#include "core/fields.hpp"
#include "core/file.hpp"
#include "core/nearest.hpp"
#include "core/number.hpp"
#include "core/toml.hpp"
#include "core/unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace platen::fit {
namespace {

using core::InvalidInput;
using core::Table;
using core::Value;

std::optional<double> number_of(const Value& value) {
  if (const auto* d = std::get_if<double>(&value.data)) return *d;
  if (const auto* i = std::get_if<std::int64_t>(&value.data)) return static_cast<double>(*i);
  return {};
}

double number_at(const Table& table, const core::Entry& entry) {
  if (const auto number = number_of(entry.value)) return *number;
  throw InvalidInput(fmt::format("{} = {} is {}, not a number", core::place(table, entry.key),
                                 core::text_of(entry.value), core::kind_of(entry.value)));
}

std::vector<double> numbers_at(const Table& table, const core::Entry& entry) {
  std::vector<double> numbers;
  if (const auto* list = std::get_if<std::vector<Value>>(&entry.value.data))
    for (const Value& item : *list) {
      const auto number = number_of(item);
      if (!number)
        throw InvalidInput(fmt::format("{} is not a list of numbers", core::place(table, entry.key)));
      numbers.push_back(*number);
    }
  else numbers.push_back(number_at(table, entry));
  return numbers;
}

std::string text_at(const Table& table, std::string_view key, bool needed) {
  const Value* value = table.find(key);
  if (!value && !needed) return {};
  if (value)
    if (const auto* text = std::get_if<std::string>(&value->data)) return *text;
  throw InvalidInput(fmt::format("{} {}", core::place(table, key), value ? "is not a text" : "is missing"));
}

std::vector<std::string> keys_of(const law::LawInfo& info) {
  std::vector<std::string> keys;
  for (const auto& p : info.parameters) keys.emplace_back(p.key);
  for (const auto& w : info.words) keys.emplace_back(w.key);
  return keys;
}

/// The list or the word or the number of a card as the text that `-p` would give.
std::string parameter_text(const Table& table, const core::Entry& entry) {
  if (const auto* word = std::get_if<std::string>(&entry.value.data)) return *word;
  std::string text;
  for (double number : numbers_at(table, entry))
    text += (text.empty() ? "" : ",") + core::number_text(number);
  return text;
}

const law::LawInfo& info_of(const Table& card, const std::string& name) {
  std::vector<std::string> known;
  for (const auto& info : law::laws()) known.emplace_back(info.name);
  if (std::ranges::find(known, name) == known.end())
    throw InvalidInput(fmt::format("{} = \"{}\": there is no such law{}", core::place(card, "law"), name,
                                   core::suggestion(name, known)));
  return law::find_law(name);
}

void check_range(const Table& section, const law::LawInfo& info, const core::Entry& entry) {
  for (const auto& p : info.parameters)
    if (p.key == entry.key)
      if (const double value = number_at(section, entry); !p.range.contains(value))
        throw InvalidInput(fmt::format("{} = {} is not in {}", core::place(section, entry.key),
                                       core::number_text(value), law::text(p.range)));
}

core::FieldValue numeric(const Table& table, const core::Entry& entry) {
  if (std::holds_alternative<std::vector<Value>>(entry.value.data)) return numbers_at(table, entry);
  return number_at(table, entry);
}

/// A value as it stands.
core::FieldValue remark(const Table& table, const core::Entry& entry) {
  if (const auto* text = std::get_if<std::string>(&entry.value.data)) return *text;
  if (const auto* truth = std::get_if<bool>(&entry.value.data)) return *truth;
  if (const auto* whole = std::get_if<std::int64_t>(&entry.value.data))
    if (std::in_range<int>(*whole)) return static_cast<int>(*whole);
  return numeric(table, entry);
}

bool is_number(const std::string& text) { return core::number_from(text).has_value(); }

} // namespace

core::FieldValue value_of(const Remarks& remarks, std::string_view key) {
  for (const auto& [name, value] : remarks)
    if (name == key) return value;
  return {};
}

LawCard read_law_card(const std::string& what) {
  return read_law_card(core::read_toml(core::find_card("laws", what)));
}

LawCard find_law_card(const std::string& what) {
  const auto cards = core::card_names("laws");
  for (const auto& l : law::laws())
    if (l.name == what) {
      LawCard card;
      card.law = what;
      return card;
    }
  if (core::is_there(what) || what.ends_with(".toml") || std::ranges::count(cards, what))
    return read_law_card(what);
  std::string known;
  for (const auto& l : law::laws()) known += fmt::format("{}{}", known.empty() ? "" : ", ", l.name);
  for (const auto& name : cards) known += ", " + name;
  throw InvalidInput(fmt::format("there is no law or law card '{}'; known are: {}", what, known));
}

LawCard read_law_card(const Table& table) {
  static const std::vector<std::string> known = {"platen",   "law",   "variant",   "parameters",
                                                 "validity", "error", "provenance"};
  for (const auto& entry : table.entries)
    for (const auto& [key, kind] : {std::pair{"model", "a material"}, std::pair{"experiment", "a case"}})
      if (entry.key == key)
        throw InvalidInput(fmt::format("{} says that this is {} card; a law card is wanted, with the key law",
                                       core::place(table, key), kind));
  core::refuse_unknown_keys(table, known);
  if (const Value* format = table.find("platen"); format && number_of(*format) != 1)
    throw InvalidInput(fmt::format("{} = {} is not allowed; the format of the card is 1",
                                   core::place(table, "platen"), core::text_of(*format)));
  LawCard card;
  card.file = table.file;
  card.law = text_at(table, "law", true);
  const law::LawInfo& info = info_of(table, card.law);
  card.variant = text_at(table, "variant", false);
  const auto variants = law::detail::split(info.variants, '|');
  if (!card.variant.empty() && std::ranges::find(variants, card.variant) == variants.end())
    throw InvalidInput(fmt::format("{} = \"{}\" is no variant of {}{}", core::place(table, "variant"),
                                   card.variant, card.law, core::suggestion(card.variant, variants)));
  if (const Table* written = core::section(table, "parameters")) {
    const Table parameters = core::in_si(*written, keys_of(info)).value_or(*written);
    core::refuse_unknown_keys(parameters, keys_of(info));
    for (const auto& entry : parameters.entries) {
      check_range(parameters, info, entry);
      card.parameters[entry.key] = parameter_text(parameters, entry);
    }
  }
  if (const Table* validity = core::section(table, "validity")) {
    core::refuse_unknown_keys(*validity, std::vector<std::string>{"delta_bar"});
    for (const auto& entry : validity->entries) {
      const auto ends = numbers_at(*validity, entry);
      if (ends.size() != 2 || !(ends[0] < ends[1]))
        throw InvalidInput(fmt::format("{} must be two growing numbers", core::place(*validity, entry.key)));
      card.delta_bar = {ends[0], ends[1]};
    }
  }
  if (const Table* errors = core::section(table, "error"))
    for (const auto& entry : errors->entries) card.errors.emplace_back(entry.key, numeric(*errors, entry));
  if (const Table* provenance = core::section(table, "provenance"))
    for (const auto& entry : provenance->entries)
      card.provenance.emplace_back(entry.key, remark(*provenance, entry));
  return card;
}

std::string text_of(const LawCard& card) {
  const law::LawInfo& info = law::find_law(card.law);
  std::string text = fmt::format("platen = 1\nlaw = {}\n", core::in_quotes(card.law));
  if (!card.variant.empty()) text += fmt::format("variant = {}\n", core::in_quotes(card.variant));
  text += "\n[parameters]\n";
  for (const auto& key : keys_of(info)) { // in the order of the law, not of the alphabet
    const auto found = card.parameters.find(key);
    if (found == card.parameters.end()) continue;
    const auto parts = law::detail::split(found->second, ',');
    const bool list =
        std::ranges::any_of(info.words, [&](const auto& w) { return w.key == key && w.values.empty(); });
    if (list) text += fmt::format("{} = [{}]\n", key, fmt::join(parts, ", "));
    else
      text +=
          fmt::format("{} = {}\n", key,
                      is_number(found->second) || found->second == "inf" ? found->second
                                                                         : core::in_quotes(found->second));
  }
  if (card.delta_bar)
    text += fmt::format("\n[validity]\ndelta_bar = [{}, {}]\n", core::number_text((*card.delta_bar)[0]),
                        core::number_text((*card.delta_bar)[1]));
  if (!card.errors.empty()) text += "\n[error]\n";
  for (const auto& [key, value] : card.errors) text += core::card_line(key, value);
  if (!card.provenance.empty()) text += "\n[provenance]\n";
  for (const auto& [key, value] : card.provenance) text += core::card_line(key, value);
  return text;
}

Validity validity_of(const LawCard& card, const law::Law& law) {
  if (!card.delta_bar) return {};
  const auto [from, to] = *card.delta_bar;
  return {from * (1 - 1e-12) / law.scale.x_per_gamma, to * (1 + 1e-12) / law.scale.x_per_gamma};
}

Validity common(const Validity& one, const Validity& two) {
  return {std::max(one.from, two.from), std::min(one.to, two.to)};
}

law::Law make_law(const LawCard& card, const law::ParameterTexts& more) {
  law::ParameterTexts parameters = card.parameters;
  for (const auto& [key, value] : more) parameters[key] = value;
  try {
    return law::make_law(card.law, card.variant, parameters);
  } catch (const law::BadParameter& error) {
    throw InvalidInput(card.file.empty() ? error.what() : fmt::format("{}: {}", card.file, error.what()));
  }
}

law::LawChoice body_of(const LawCard& card, bool on_plane) {
  const auto against = card.parameters.find("against");
  if (!on_plane && against != card.parameters.end() && against->second == "plane")
    throw InvalidInput(
        fmt::format("{}: the card is for a sphere against a plane, not between spheres", card.file));
  for (const auto& p : law::find_law(card.law).parameters)
    for (const std::string& key :
         {std::string("radius2_m"), p.of == law::Of::body ? law::second_key(p.key) : ""})
      if (const auto found = card.parameters.find(key); found != card.parameters.end())
        throw InvalidInput(fmt::format(
            "{}: the card is for one pair of unlike spheres ({} = {}); give a card for each material",
            card.file, key, found->second));
  law::LawChoice one{card.law, card.variant, card.parameters};
  one.parameters.erase("radius_m");
  one.parameters.erase("against");
  return one;
}

law::Law make_law(const LawCard& one, const LawCard& two, const law::ParameterTexts& radii) {
  const law::LawChoice first_body = body_of(one), second_body = body_of(two);
  const auto radius_of = [&](const char* key, const LawCard& card) -> std::optional<double> {
    const auto given = radii.find(key), own = card.parameters.find("radius_m");
    if (given == radii.end() && own == card.parameters.end()) return std::nullopt;
    const std::string& text = given != radii.end() ? given->second : own->second;
    if (const auto number = core::number_from(text)) return number;
    throw InvalidInput(fmt::format("{} = {} is not a number", key, text));
  };
  const auto first = radius_of("radius_m", one);
  if (!first) throw InvalidInput("radius_m is missing: the radius of the first body [m]");
  const double second = radius_of("radius2_m", two).value_or(*first);
  try {
    return law::make_law(first_body, *first, second_body, second);
  } catch (const law::BadParameter& error) {
    throw InvalidInput(fmt::format("{} with {}: {}", one.file.empty() ? one.law : one.file,
                                   two.file.empty() ? two.law : two.file, error.what()));
  }
}

} // namespace platen::fit
