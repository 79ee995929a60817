#include "core/unit.hpp"

#include "core/error.hpp"
#include "core/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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
constexpr std::array<std::string_view, 6> si_units = {"Pa", "m", "N", "J", "deg", "kg_per_m3"};

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
  for (const auto& unit : units)
    if (key.ends_with(fmt::format("_{}", unit.name))) return {unit.si, unit.in_si};
  for (const auto si : si_units)
    if (key.ends_with(fmt::format("_{}", si))) return {si, 1};
  return {};
}

} // namespace

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
      return fmt::format("{}, in {}", right, si);
  return {};
}

} // namespace platen::core
