#pragma once
// The law card of a fit to a curve.

#include "fit/fitted_law.hpp"
#include "fit/law_card.hpp"
#include "press/curve.hpp"

#include <string_view>

namespace platen::fit {

/// Loading, contact radius and unloading as one card; `curve_text` is the curve.csv that was fitted, for its
/// fingerprint. Without unloading branches the law unloads generically. Throws core::InvalidInput when the
/// card cannot hold the branches: more than eight, or two from the same overlap.
LawCard law_card(const press::Curve&, const FittedLaw&, std::string_view curve_text);

} // namespace platen::fit
