#pragma once
// Law cards: a fitted or published law in a file. What a parameter may be is said once, in
// platen/law/catalogue.hpp; a card adds where it came from and how far it holds.

#include "platen/law/catalogue.hpp"

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace platen::fit {

struct LawCard {
  std::string file; ///< as messages name it
  std::string law;
  std::string variant;            ///< empty: the law's default
  law::ParameterTexts parameters; ///< as `platen eval -p` takes them; usually without the radius
  std::optional<std::array<double, 2>> delta_bar; ///< [validity]
  std::map<std::string, double> errors;           ///< [error]
  std::map<std::string, std::string> provenance;  ///< [provenance]
};

/// A card by path, or by name in the folder "laws" of a catalogue. Throws core::InvalidInput with file and
/// line for an unknown law, variant, section or key, and for a parameter outside its range.
LawCard read_law_card(const std::string& what);

/// The card as text; reading it gives the same card.
std::string text_of(const LawCard&);

/// The law of a card, or of a bare name, ready to be evaluated. `more`: parameters that add to those of the
/// card or replace them. Throws core::InvalidInput.
law::AnyLaw make_law(const LawCard&, const law::ParameterTexts& more);

} // namespace platen::fit
