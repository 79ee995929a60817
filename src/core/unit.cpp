#include "core/unit.hpp"

#include "core/error.hpp"
#include "core/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

namespace platen::core {
namespace {

struct Unit {
  std::string_view name, si;
  double in_si;
};

constexpr std::array units = {
    Unit{"kPa", "Pa", 1e3},
    Unit{"MPa", "Pa", 1e6},
    Unit{"GPa", "Pa", 1e9},
    Unit{"psi", "Pa", 6894.757293168},
    Unit{"ksi", "Pa", 6894757.293168},
    Unit{"cm", "m", 1e-2},
    Unit{"mm", "m", 1e-3},
    Unit{"um", "m", 1e-6},
    Unit{"nm", "m", 1e-9},
    Unit{"mN", "N", 1e-3},
    Unit{"uN", "N", 1e-6},
    Unit{"kN", "N", 1e3},
    Unit{"MN", "N", 1e6},
    Unit{"mJ", "J", 1e-3},
    Unit{"uJ", "J", 1e-6},
    Unit{"kJ", "J", 1e3},
    Unit{"rad", "deg", 180 / std::numbers::pi},
    Unit{"g_per_cm3", "kg_per_m3", 1e3},
};
constexpr std::array<std::string_view, 8> si_units = {"Pa",  "m",         "N",       "J",
                                                      "deg", "kg_per_m3", "m_per_N", "N_per_m"};
/// What people write beside a number and nobody at the end of a key.
constexpr std::array written_units = {
    Unit{"Pa", "Pa", 1},   Unit{"bar", "Pa", 1e5}, Unit{"m", "m", 1},        Unit{"in", "m", 0.0254},
    Unit{"N", "N", 1},     Unit{"J", "J", 1},      Unit{"deg", "deg", 1},    Unit{"kg", "kg", 1},
    Unit{"g", "kg", 1e-3}, Unit{"t", "kg", 1e3},   Unit{"tonne", "kg", 1e3}, Unit{"s", "s", 1},
    Unit{"ms", "s", 1e-3}, Unit{"min", "s", 60},
};
/// 1/m of a hardening exponent, no length.
constexpr std::string_view no_length = "inverse_m";

/// "kg_per_m3" as it is written: "kg/m3".
std::string unit_in_words(std::string_view si) {
  std::string text(si);
  if (const auto per = text.find("_per_"); per != text.npos) text.replace(per, 5, "/");
  return text;
}

std::optional<double> number(const Value& value) {
  if (const auto* x = std::get_if<double>(&value.data)) return *x;
  if (const auto* i = std::get_if<std::int64_t>(&value.data)) return static_cast<double>(*i);
  return std::nullopt;
}

/// The SI unit in which a key measures, and its own unit in it.
struct Measure {
  std::string_view si;
  double in_si = 1;
};
Measure measure_of(std::string_view key) {
  Measure found;
  for (const auto& unit : units)
    if (key.ends_with(fmt::format("_{}", unit.name))) return {unit.si, unit.in_si};
  for (const auto si : si_units) // m_per_N ends in N as well
    if (key.ends_with(fmt::format("_{}", si)) && si.size() > found.si.size()) found = {si, 1};
  return found;
}

/// "µm³" as "um3".
std::string plain(std::string_view text) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 7> signs = {{{"\u00b5", "u"},
                                                                                          {"\u03bc", "u"},
                                                                                          {"\u00b0", "deg"},
                                                                                          {"\u00b2", "2"},
                                                                                          {"\u00b3", "3"},
                                                                                          {"^", ""},
                                                                                          {" ", ""}}};
  std::string result(text);
  for (const auto& [from, to] : signs)
    for (auto at = result.find(from); at != result.npos; at = result.find(from, at))
      result.replace(at, from.size(), to);
  return result;
}

/// "mm", "mm2", "g/cm3".
std::optional<Quantity> unit_from(const std::string& text) {
  if (const auto slash = text.find('/'); slash != text.npos) {
    const auto above = unit_from(text.substr(0, slash)), below = unit_from(text.substr(slash + 1));
    if (!above || !below) return {};
    const std::string si = above->si + "_per_" + below->si;
    return Quantity{above->in_si / below->in_si, si == "N_per_m2" ? "Pa" : si};
  }
  const auto find = [](std::string_view name) -> std::optional<Quantity> {
    for (const auto& list : {std::span<const Unit>(units), std::span<const Unit>(written_units)})
      for (const auto& unit : list)
        if (unit.name == name) return Quantity{unit.in_si, std::string(unit.si)};
    return {};
  };
  if (const auto whole = find(text)) return whole;
  if (text.empty() || (text.back() != '2' && text.back() != '3')) return {};
  const int power = text.back() - '0';
  const auto one = find(text.substr(0, text.size() - 1));
  if (!one || one->si != "m") return {};
  return Quantity{std::pow(one->in_si, power), one->si + text.back()};
}

/// "Pa, kPa, MPa, GPa, psi, ksi or bar": what may be written for an SI unit.
std::string units_of(std::string_view si) {
  std::vector<std::string> names;
  for (const auto& list : {std::span<const Unit>(written_units), std::span<const Unit>(units)})
    for (const auto& unit : list)
      if (unit.si == si && unit.name.find("_per_") == unit.name.npos) names.emplace_back(unit.name);
  if (si == "kg_per_m3") names = {"kg/m3", "g/cm3"};
  if (si == "m_per_N") names = {"m/N", "um/N"};
  if (si == "N_per_m") names = {"N/m", "N/mm"};
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += fmt::format("{}{}", i == 0 ? "" : i + 1 == names.size() ? " or " : ", ", names[i]);
  return text;
}

std::string_view quantity_words(std::string_view si) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 10> words = {
      {{"Pa", "a stress"},
       {"m", "a length"},
       {"N", "a force"},
       {"J", "an energy"},
       {"deg", "an angle"},
       {"kg_per_m3", "a density"},
       {"kg", "a mass"},
       {"s", "a time"},
       {"m_per_N", "a compliance"},
       {"N_per_m", "a stiffness"}}};
  for (const auto& [unit, word] : words)
    if (unit == si) return word;
  return "something else";
}

} // namespace

std::optional<Quantity> quantity_from(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || !std::isfinite(number)) return {};
  const auto unit = unit_from(plain({end, text.data() + text.size()}));
  if (!unit) return {};
  // Twelve digits: 1.1 mm is 1.1e-3 m, not 1.1 times what is next to 1e-3 in binary.
  return Quantity{*number_from(fmt::format("{:.12g}", number * unit->in_si)), unit->si};
}

std::string si_key(std::string_view bare, std::span<const std::string> known) {
  const auto found = std::ranges::find_if(known, [&](std::string_view key) {
    return key.size() > bare.size() && key[bare.size()] == '_' && key.starts_with(bare) && key != no_length &&
           std::ranges::find(si_units, key.substr(bare.size() + 1)) != si_units.end();
  });
  return found == known.end() ? std::string{} : *found;
}

double value_in_si(std::string_view place, std::string_view text, std::string_view key) {
  const auto si = measure_of(key).si;
  const auto quantity = quantity_from(text);
  if (!quantity)
    throw InvalidInput(
        fmt::format("{} = \"{}\" is no number with a unit; its units are {}", place, text, units_of(si)));
  if (quantity->si != si)
    throw InvalidInput(fmt::format("{} = \"{}\" is {}; it must be {}, in {}", place, text,
                                   quantity_words(quantity->si), quantity_words(si), units_of(si)));
  return quantity->in_si;
}

std::optional<Table> in_si(const Table& table, std::span<const std::string> known) {
  std::optional<Table> result;
  for (std::size_t i = 0; i < table.entries.size(); ++i) {
    const auto is_text = [](const Value& value) { return std::holds_alternative<std::string>(value.data); };
    const Value& written = table.entries[i].value;
    const auto* texts = std::get_if<std::vector<Value>>(&written.data);
    if (!(texts ? std::ranges::any_of(*texts, is_text) : is_text(written))) continue;
    const std::string key = si_key(table.entries[i].key, known);
    if (key.empty()) continue;
    if (!result) result = table;
    Entry& entry = result->entries[i];
    const auto convert = [&](Value& value) {
      if (!is_text(value))
        throw InvalidInput(
            fmt::format("{}: each value of the list must have its unit", place(table, entry.key)));
      value.data = value_in_si(place(table, entry.key), std::get<std::string>(value.data), key);
    };
    if (table.find(key))
      throw InvalidInput(fmt::format("{}: given as well as {}; exactly one of the two is allowed",
                                     place(table, entry.key), key));
    if (texts) std::ranges::for_each(std::get<std::vector<Value>>(entry.value.data), convert);
    else convert(entry.value);
    entry.key = key;
  }
  return result;
}

double in_units_of(std::string_view key, std::string_view other) {
  const Measure own = measure_of(key), its = measure_of(other);
  const auto in_words = [](const Measure& m) { return m.si.empty() ? "no unit" : m.si; };
  if (own.si != its.si)
    throw InvalidInput(
        fmt::format("'{}' is in {} and cannot serve '{}', which is in {}; units are the ends of "
                    "names, as in E_MPa",
                    other, in_words(its), key, in_words(own)));
  return its.in_si / own.in_si;
}

std::string line_in_si(std::string_view key, const Value& value, std::span<const std::string> known) {
  const auto is_known = [&](const std::string& name) {
    return std::find(known.begin(), known.end(), name) != known.end();
  };
  for (const auto& unit : units) {
    const std::string ending = fmt::format("_{}", unit.name);
    if (!key.ends_with(ending)) continue;
    const std::string right = fmt::format("{}_{}", key.substr(0, key.size() - ending.size()), unit.si);
    if (!is_known(right)) continue;
    const auto x = number(value);
    if (!x) return fmt::format("{}, in {}", right, unit.si);
    // Twelve digits: the conversion must not show that 1.1e-3 is not 1.1 times 1e-3 in binary.
    return fmt::format("{} = {}", right, number_text(*number_from(fmt::format("{:.12g}", *x * unit.in_si))));
  }
  for (const auto si : si_units)
    if (const std::string right = fmt::format("{}_{}", key, si); is_known(right))
      return fmt::format("{}, in {}, or {} = \"{} {}\" with its unit", right, si, key,
                         number(value) ? number_text(*number(value)) : "...", unit_in_words(si));
  return {};
}

} // namespace platen::core
