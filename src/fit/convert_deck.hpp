#pragma once
// From the material section of a deck to a card that is believed.

#include "material/deck.hpp"

namespace platen::fit {

struct ConvertedCard {
  std::string card;                   ///< text, with where it is from
  std::vector<std::string> said;      ///< how it was read
  std::vector<std::string> left_over; ///< what has no counterpart here
  std::vector<std::string> doubts;    ///< why the units are hardly those
};

/// InvalidInput for what the model does not admit, and for numbers of no material on this planet, which are
/// those of other units; the latter not `despite_doubts`.
ConvertedCard convert_deck(const material::DeckMaterial&, const material::DeckUnits&,
                           std::optional<double> rho_r0, bool despite_doubts);

} // namespace platen::fit
