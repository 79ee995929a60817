#pragma once
// The law card of a predicted curve.

#include "fit/law_card.hpp"
#include "material/models.hpp"
#include "surrogate/assess.hpp"

#include <string>

namespace platen::surrogate {

/// The curve as the law `pressed`. InvalidInput where it does not grow.
fit::LawCard pressed_card(const Answer&, const material::Material&);
/// The law `edmans-sinka` fitted to the curve.
fit::LawCard edmans_sinka_card(const Answer&, const material::Material&, const std::string& variant);

} // namespace platen::surrogate
