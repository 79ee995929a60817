#pragma once
// Law cards: a fitted or published law in a file. What a parameter may be is said once, in
// platen/law/catalogue.hpp; a card adds where it came from and how far it holds.

#include "core/fields.hpp"
#include "core/toml.hpp"
#include "platen/law/catalogue.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace platen::fit {

/// A section that says about the law, not to it: keys and values in the order of the card.
using Remarks = std::vector<std::pair<std::string, core::FieldValue>>;

struct LawCard {
  std::string file; ///< as messages name it
  std::string law;
  std::string variant;            ///< empty: the law's default
  law::ParameterTexts parameters; ///< as `platen eval -p` takes them; usually without the radius
  std::optional<std::array<double, 2>> delta_bar; ///< [validity]
  Remarks errors;                                 ///< [error]
  Remarks provenance;                             ///< [provenance]
};

/// The value of a key; monostate when it is not there.
core::FieldValue value_of(const Remarks&, std::string_view key);

/// A card by path, or by name in the folder "laws" of a catalogue. Throws core::InvalidInput with file and
/// line for an unknown law, variant, section or key, and for a parameter outside its range.
LawCard read_law_card(const std::string& what);
LawCard read_law_card(const core::Table&);

/// What a user may name: a card by path, one of the catalogue, or a law, which gives an empty card of it.
/// InvalidInput lists what there is.
LawCard find_law_card(const std::string& what);

/// The card as text; reading it gives the same card.
std::string text_of(const LawCard&);

/// The law of a card, or of a bare name, ready to be evaluated. `more`: parameters that add to those of the
/// card or replace them. Throws core::InvalidInput.
law::Law make_law(const LawCard&, const law::ParameterTexts& more);

/// The one body that a card is for, without its radius. Throws core::InvalidInput for a card that says what
/// of a second body, or, where it is not `on_plane`, that is for a sphere against a plane.
law::LawChoice body_of(const LawCard&, bool on_plane = false);

/// Two bodies, each with its own card. `radii`: radius_m, and radius2_m where it is not the same [m]. Throws
/// core::InvalidInput.
law::Law make_law(const LawCard& one, const LawCard& two, const law::ParameterTexts& radii);

/// Largest overlaps for which cards hold, which may be fewer than those of their laws [m].
struct Validity {
  double from = 0, to = law::infinity;

  /// A contact that never touched is right anyhow.
  [[nodiscard]] bool holds(double largest) const {
    return largest <= 0 || (from <= largest && largest <= to);
  }
};
Validity validity_of(const LawCard&, const law::Law&);
Validity common(const Validity&, const Validity&);

} // namespace platen::fit
