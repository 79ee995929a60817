#pragma once
// How the command line names a law: a card or a bare name, parameters, what it touches, and overlaps. What
// `eval`, `laws` and `export` share.

#include "app/command_line.hpp"
#include "fit/law_card.hpp"

#include <string>
#include <utility>
#include <vector>

namespace platen::app {

struct LawArguments {
  std::string law; ///< card path, card name or law name
  std::string variant;
  std::vector<std::string> parameters; ///< key=value
  std::string against = "sphere";
};

void add_law_arguments(Command, LawArguments&);

/// The card that is meant; a bare law name is an empty card of that law. InvalidInput lists what there is.
fit::LawCard card_of(const LawArguments&);
/// The card's parameters with those of the command line over them.
law::ParameterTexts parameters_of(const LawArguments&);

/// "key=value", also "E=2 GPa" for E_Pa. InvalidInput.
std::pair<std::string, std::string> parameter_from(const std::string& text);

/// The numbers of "A:B" or "A:B:N", what `option` was given; with a key, in its unit or with one behind them.
std::vector<double> numbers_of_range(const std::string& option, const std::string& range,
                                     const std::string& key = "");

/// "A:B:N": N overlaps from A to B, both included; in m, or with a unit: 0:100um:11.
std::vector<double> overlaps_of(const std::string& range);

} // namespace platen::app
