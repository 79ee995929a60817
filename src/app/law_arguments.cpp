#include "app/law_arguments.hpp"

#include "core/error.hpp"
#include "core/number.hpp"

#include <fmt/format.h>

#include <cmath>

namespace platen::app {

using core::InvalidInput;

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
  for (const auto& p : arguments.parameters) {
    const auto equals = p.find('=');
    if (equals == std::string::npos || equals == 0)
      throw InvalidInput(fmt::format("-p {} is not of the form key=value", p));
    if (!texts.emplace(p.substr(0, equals), p.substr(equals + 1)).second)
      throw InvalidInput(fmt::format("-p {} is given twice", p.substr(0, equals)));
  }
  if (arguments.against != "sphere" && arguments.against != "plane")
    throw InvalidInput(fmt::format("--against {} is neither sphere nor plane", arguments.against));
  if (arguments.against == "plane") texts["against"] = "plane";
  return texts;
}

std::vector<double> overlaps_of(const std::string& range) {
  const auto parts = law::detail::split(range, ':');
  const auto number = [&](std::size_t i) {
    const auto value = core::number_from(parts[i]);
    if (!value) throw InvalidInput(fmt::format("--overlap {}: '{}' is not a number", range, parts[i]));
    return *value;
  };
  if (parts.size() == 1) {
    const double one = number(0);
    if (!std::isfinite(one))
      throw InvalidInput(fmt::format("--overlap {}: it must be a finite number", range));
    return {one};
  }
  if (parts.size() != 3)
    throw InvalidInput(fmt::format("--overlap {} is not of the form FROM:TO:COUNT, nor one number", range));
  const double from = number(0), to = number(1), count = number(2);
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
