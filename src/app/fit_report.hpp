#pragma once
// A law fitted to a curve, told in words and as JSON. What `fit` and `derive` share.

#include "fit/fitted_law.hpp"
#include "fit/pressed.hpp"
#include "press/curve.hpp"

#include <optional>
#include <string>

namespace platen::app {

using fit::FittedLaw;

inline constexpr const char* variant_help =
    "form of the law: published, c1, hertz-like; best: whichever of them fits best";

/// A few lines for people.
std::string fit_words(const FittedLaw&);
std::string fit_words(const fit::PressedFit&);

/// A JSON object.
std::string fit_json(const press::Curve&, const FittedLaw&, const std::optional<fit::PressedFit>& = {});
std::string fit_json(const press::Curve&, const fit::PressedFit&);

} // namespace platen::app
