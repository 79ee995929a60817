#include "app/law_arguments.hpp"

#include "core/error.hpp"
#include "core/number.hpp"
#include "core/unit.hpp"
#include "material/card.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace platen::app {

using core::InvalidInput;

namespace {

/// Keys of all laws and materials, by which a bare name is known.
const std::vector<std::string>& parameter_keys() {
  static const auto keys = [] {
    std::vector<std::string> list;
    for (const auto& info : law::laws())
      for (const auto& p : info.parameters)
        list.emplace_back(p.key), list.emplace_back(law::second_key(p.key));
    material::for_each_model([&]<class M>() {
      for (const auto& field : M::card().fields) list.push_back(field.key);
    });
    return list;
  }();
  return keys;
}

} // namespace

std::pair<std::string, std::string> parameter_from(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw InvalidInput(fmt::format("-p {} is not of the form key=value", text));
  std::string key = text.substr(0, equals), value = text.substr(equals + 1);
  if (std::ranges::count(parameter_keys(), key)) return {key, value};
  const auto known = core::si_key(key, parameter_keys());
  if (known.empty()) return {key, value};
  if (core::number_from(value))
    throw InvalidInput(fmt::format(
        "-p {} has no unit; write -p {}={}, which is in SI units, or a unit behind it", text, known, value));
  return {known, core::number_text(core::value_in_si("-p " + key, value, known))};
}

void add_law_arguments(Command command, LawArguments& arguments) {
  command.add_option("LAW", arguments.law, "law card, its name in the catalogue, or the name of a law")
      .required();
  command.add_option("-p", arguments.parameters, "parameter, key=value; `platen laws NAME` lists them");
  command.add_option("--variant", arguments.variant, "variant of the law");
  command.add_option("--against", arguments.against, "sphere (default), or plane: a rigid one");
}

fit::LawCard card_of(const LawArguments& arguments) {
  fit::LawCard card = fit::find_law_card(arguments.law);
  if (!arguments.variant.empty()) card.variant = arguments.variant;
  return card;
}

law::ParameterTexts parameters_of(const LawArguments& arguments) {
  law::ParameterTexts texts;
  for (const auto& p : arguments.parameters)
    if (const auto [at, is_new] = texts.insert(parameter_from(p)); !is_new)
      throw InvalidInput(fmt::format("-p {} is given twice", at->first));
  if (arguments.against != "sphere" && arguments.against != "plane")
    throw InvalidInput(fmt::format("--against {} is neither sphere nor plane", arguments.against));
  if (arguments.against == "plane") texts["against"] = "plane";
  return texts;
}

std::vector<double> numbers_of_range(const std::string& option, const std::string& range,
                                     const std::string& key) {
  std::vector<double> numbers;
  for (const auto& part : law::detail::split(range, ':')) {
    const auto value = core::number_from(part);
    if (!value && !key.empty() && core::quantity_from(part))
      numbers.push_back(core::value_in_si(fmt::format("{} {}: one end", option, range), part, key));
    else if (value) numbers.push_back(*value);
    else throw InvalidInput(fmt::format("{} {}: '{}' is not a number", option, range, part));
  }
  return numbers;
}

std::vector<double> overlaps_of(const std::string& range) {
  const auto parts = numbers_of_range("--overlap", range, "overlap_m");
  if (parts.size() == 1) {
    if (!std::isfinite(parts[0]))
      throw InvalidInput(fmt::format("--overlap {}: it must be a finite number", range));
    return parts;
  }
  if (parts.size() != 3)
    throw InvalidInput(fmt::format("--overlap {} is not of the form FROM:TO:COUNT, nor one number", range));
  const double from = parts[0], to = parts[1], count = parts[2];
  if (!std::isfinite(from) || !std::isfinite(to))
    throw InvalidInput(fmt::format("--overlap {}: both ends must be finite numbers", range));
  if (from == to) throw InvalidInput(fmt::format("--overlap {}: the range is empty", range));
  if (!(count >= 2) || count > 1e7 || count != static_cast<int>(count))
    throw InvalidInput(fmt::format("--overlap {}: the count must be a whole number from 2 to 1e7", range));
  std::vector<double> overlaps;
  const int n = static_cast<int>(count);
  for (int i = 0; i < n; ++i) overlaps.push_back(i == n - 1 ? to : from + (to - from) * i / (n - 1));
  return overlaps;
}

} // namespace platen::app
