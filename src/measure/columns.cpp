#include "measure/columns.hpp"

#include "core/error.hpp"
#include "core/toml.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace platen::measure {
namespace {

using core::InvalidInput;

/// "Force 2" and "Force 1" head the same quantity.
std::string without_digits(std::string_view name) {
  std::string result = folded(name);
  std::erase_if(result, [](char c) { return (c >= '0' && c <= '9') || c == ' '; });
  return result;
}

/// COLUMN:UNIT taken apart; a colon may belong to the name.
struct Asked {
  std::string column, unit;
};
Asked asked(const std::string& option) {
  const auto at = option.rfind(':');
  if (at != option.npos && at > 0)
    if (unit_named(option.substr(at + 1))) return {option.substr(0, at), option.substr(at + 1)};
  return {option, {}};
}

struct Choice {
  const Sheet& sheet;
  const Table& table;
  const Group& group;

  const Column& at(std::size_t k) const { return table.columns[k]; }
  std::string here() const { return fmt::format("{}, line {}", sheet.file, table.line); }
  std::string listed(const std::vector<std::size_t>& columns) const {
    std::vector<std::string> names;
    for (auto k : columns) names.push_back(core::in_quotes(at(k).heading.text));
    return fmt::format("{}", fmt::join(names, ", "));
  }
  std::vector<std::size_t> all() const {
    std::vector<std::size_t> columns;
    for (auto k = group.first; k < group.first + group.count; ++k)
      if (!at(k).heading.text.empty()) columns.push_back(k);
    return columns;
  }

  /// By what stands in the header: all of it, the name, or a part that only one column has.
  std::size_t named(const std::string& name, std::string_view option) const {
    std::vector<std::size_t> found;
    if (const auto number = name.starts_with('#') ? number_in(name.substr(1), Dialect{}) : std::nullopt)
      if (const auto k = static_cast<std::size_t>(*number - 1); *number >= 1 && k < group.count)
        return group.first + k;
    const std::string wanted = folded(name);
    for (auto k : all())
      if (at(k).heading.text == name || folded(at(k).heading.text) == wanted) found.push_back(k);
    if (found.empty())
      for (auto k : all())
        if (folded(at(k).heading.name) == wanted) found.push_back(k);
    if (found.empty() && !wanted.empty())
      for (auto k : all())
        if (folded(at(k).heading.text).find(wanted) != std::string::npos) found.push_back(k);
    if (found.size() == 1) return found.front();
    throw InvalidInput(fmt::format("{}: {} {} is {}; there are {}", here(), option, core::in_quotes(name),
                                   found.empty() ? "no column" : "more than one column, #1 is the first",
                                   listed(all())));
  }

  /// Columns whose words say the quantity, and whose unit does not say another.
  std::vector<std::size_t> by_words(Quantity quantity) const {
    std::vector<std::size_t> found;
    for (auto k : all()) {
      const auto& heading = at(k).heading;
      if (quantity_named(heading.name) != quantity || is_dead(at(k))) continue;
      const auto unit = unit_named(heading.unit);
      if (heading.unit.empty() || (unit && unit->measures == quantity)) found.push_back(k);
    }
    return found;
  }
  /// Columns that no words tell, by their unit.
  std::vector<std::size_t> by_unit(Quantity quantity) const {
    std::vector<std::size_t> found;
    for (auto k : all()) {
      const auto unit = unit_named(at(k).heading.unit);
      if (unit && unit->measures == quantity && !is_dead(at(k)) &&
          quantity_named(at(k).heading.name) == Quantity::other)
        found.push_back(k);
    }
    return found;
  }

  Chosen choose(Quantity quantity, const std::string& option_value, std::string_view option) const {
    const std::string_view word = quantity == Quantity::force ? "force" : "displacement";
    if (!option_value.empty()) {
      const Asked wanted = asked(option_value);
      const auto k = named(wanted.column, option);
      const std::string& unit = wanted.unit.empty() ? at(k).heading.unit : wanted.unit;
      return {k, unit.empty() ? Unit{} : measured(k, unit, quantity, option)};
    }
    auto found = by_words(quantity);
    if (found.empty()) found = by_unit(quantity);
    if (found.empty())
      throw InvalidInput(
          fmt::format("{}: no column is known as a {}; there are {}; name it with {} COLUMN:UNIT", here(),
                      word, listed(all()), option));
    if (found.size() > 1)
      throw InvalidInput(fmt::format("{}: {} columns could be the {}: {}; name the one to take{} with {}, by "
                                     "its words or as #1, #2, ...",
                                     here(), found.size(), word, listed(found),
                                     quantity == Quantity::force
                                         ? ""
                                         : ", the way between the platens rather than that of the crosshead,",
                                     option));
    const auto& unit = at(found.front()).heading.unit;
    return {found.front(), unit.empty() ? Unit{} : measured(found.front(), unit, quantity, option)};
  }

  Unit measured(std::size_t k, const std::string& text, Quantity quantity, std::string_view option) const {
    const auto unit = unit_named(text);
    if (unit && unit->measures == quantity) return *unit;
    throw InvalidInput(fmt::format("{}, column {}: {} is no unit of {} that is known; name it with {} {}:{}",
                                   here(), at(k).heading.text, core::in_quotes(text), words(quantity), option,
                                   core::in_quotes(at(k).heading.text),
                                   quantity == Quantity::force ? "N" : "mm"));
  }

  double largest(std::size_t k) const {
    double low = 0, high = 0;
    bool first = true;
    for (double v : at(k).values)
      if (std::isfinite(v)) {
        low = first ? v : std::min(low, v);
        high = first ? v : std::max(high, v);
        first = false;
      }
    return high - low;
  }

  /// The units are asked for, never guessed; but which reading would make sense can be said.
  [[noreturn]] void ask_units(const Roles& roles, const ReadOptions& options) const {
    const auto& d = roles.displacement;
    const auto& f = roles.force;
    std::vector<std::string> without;
    if (d.unit.name.empty()) without.push_back(at(d.column).heading.text);
    if (f.unit.name.empty()) without.push_back(at(f.column).heading.text);
    std::string text =
        fmt::format("{}: which unit {} {}? None stands in the file, and none is guessed; write", here(),
                    without.size() == 1 ? "has" : "have", fmt::join(without, " and which has "));
    const auto propose = [&](const Chosen& c, std::string_view option, std::string_view unit) {
      if (c.unit.name.empty())
        text += fmt::format(" {} {}:{}", option, core::in_quotes(at(c.column).heading.text), unit);
    };
    propose(f, "--force", "N");
    propose(d, "--displacement", "mm");
    const double travel = largest(d.column), force = largest(f.column);
    const double length = d.unit.name.empty() ? 1e-3 : d.unit.in_SI,
                 newton = f.unit.name.empty() ? 1 : f.unit.in_SI;
    text += ", if that is what they are in";
    if (!options.diameter_m) {
      text +=
          fmt::format(": the platens would then move {:.3g} mm and press with {:.3g} N; with --radius_m it "
                      "can be said which units make sense",
                      travel * length * 1e3, force * newton);
    } else {
      const double R = *options.diameter_m / 2, half = options.displacement_is == "contact" ? 1 : 0.5;
      std::vector<std::string> readings;
      if (d.unit.name.empty())
        for (const auto& [name, in_SI] : {std::pair{"mm", 1e-3}, std::pair{"um", 1e-6}, std::pair{"m", 1.0}})
          readings.push_back(
              fmt::format("taken as {}, delta/R would end at {:.3g}", name, half * travel * in_SI / R));
      if (f.unit.name.empty())
        readings.push_back(fmt::format("force taken as N, the mid-section would carry {:.3g} MPa",
                                       force / (std::numbers::pi * R * R) / 1e6));
      text += fmt::format(" (R = {:.4g} mm: {})", R * 1e3, fmt::join(readings, "; "));
    }
    throw InvalidInput(text);
  }
};

} // namespace

bool is_dead(const Column& column) {
  double first = 0;
  std::size_t count = 0;
  for (double v : column.values) {
    if (!std::isfinite(v)) continue;
    if (count++ == 0) first = v;
    else if (v != first) return false;
  }
  return count != 1; // also where there is no number at all
}

std::vector<Group> groups_of(const Table& table) {
  const std::size_t n = table.columns.size();
  std::vector<std::string> names;
  for (const auto& column : table.columns)
    names.push_back(without_digits(column.heading.name) + "|" + folded(column.heading.unit));
  for (std::size_t period = 2; 2 * period <= n; ++period) {
    if (n % period != 0) continue;
    bool repeats = true;
    for (std::size_t k = period; k < n; ++k) repeats = repeats && names[k] == names[k - period];
    if (!repeats) continue;
    std::vector<Group> groups;
    for (std::size_t first = 0; first < n; first += period) groups.push_back({first, period});
    return groups;
  }
  return {{0, n}};
}

Roles roles_of(const Sheet& sheet, const Table& table, const Group& group, const ReadOptions& options) {
  const Choice choice{sheet, table, group};
  Roles roles;
  roles.force = choice.choose(Quantity::force, options.force, "--force");
  roles.displacement = choice.choose(Quantity::displacement, options.displacement, "--displacement");
  if (roles.force.column == roles.displacement.column)
    throw InvalidInput(fmt::format("{}: column {} cannot be force and displacement at once", choice.here(),
                                   choice.at(roles.force.column).heading.text));
  if (roles.force.unit.name.empty() || roles.displacement.unit.name.empty()) choice.ask_units(roles, options);
  for (auto k : choice.all()) {
    if (k == roles.force.column || k == roles.displacement.column) continue;
    const auto& heading = choice.at(k).heading;
    const Quantity what = quantity_named(heading.name);
    const auto unit = unit_named(heading.unit);
    if (what == Quantity::time && unit && unit->measures == Quantity::time && !roles.time)
      roles.time = Chosen{k, *unit};
    if ((what == Quantity::diameter || what == Quantity::radius) && !roles.diameter && !options.diameter_m) {
      if (!unit || unit->measures != Quantity::displacement)
        throw InvalidInput(fmt::format("{}, column {}: this column has no unit of length; write it into the "
                                       "header, as diameter_um, or give one --diameter_m for all",
                                       choice.here(), heading.text));
      roles.diameter = Chosen{k, *unit};
      roles.diameter_is_radius = what == Quantity::radius;
    }
    if (what == Quantity::particle && !roles.particle) roles.particle = k;
  }
  return roles;
}

} // namespace platen::measure
