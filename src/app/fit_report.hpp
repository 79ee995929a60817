#pragma once
// A fitted law told three ways: as a law card, as words, as JSON. What `fit` and `derive` share.

#include "fit/edmans_sinka.hpp"
#include "press/curve.hpp"

#include <filesystem>
#include <string>

namespace platen::app {

/// The law card. `curve_text`: the curve.csv that was fitted, for its fingerprint.
std::string law_card(const press::Curve&, const fit::EdmansSinkaFit&, const std::string& curve_text);

/// A few lines for people.
std::string fit_words(const fit::EdmansSinkaFit&);

/// A JSON object.
std::string fit_json(const press::Curve&, const fit::EdmansSinkaFit&);

/// Curve, law and residual.
void draw_fit(const press::Curve&, const fit::EdmansSinkaFit&, const std::filesystem::path&);

} // namespace platen::app
