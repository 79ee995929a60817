#pragma once
// A law fitted to a curve, told in words, as JSON, as a picture. What `fit` and `derive` share.

#include "fit/edmans_sinka.hpp"
#include "fit/pressed.hpp"
#include "fit/unloading.hpp"
#include "press/curve.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace platen::app {

inline constexpr const char* variant_help =
    "form of the law: published, c1, hertz-like; best: whichever of them fits best";

struct FittedLaw {
  fit::EdmansSinkaFit loading;
  fit::UnloadingFits unloading;
  std::string verdict; ///< which form fits best, and by how much; empty where the form was given
};

/// InvalidInput unless `variant` is a form to fit, or "best"; to be asked before a press.
void check_variant(const std::string& variant);

/// Loading and unloading branches of the curve. Branches that cannot be fitted are named on standard error.
FittedLaw fit_law(const press::Curve&, const std::string& variant);

/// A few lines for people.
std::string fit_words(const FittedLaw&);
std::string fit_words(const fit::PressedFit&);

/// A JSON object.
std::string fit_json(const press::Curve&, const FittedLaw&, const std::optional<fit::PressedFit>& = {});
std::string fit_json(const press::Curve&, const fit::PressedFit&);

/// The curve's unloading branches, as both laws have them.
fit::UnloadingFits unloading_of(const press::Curve&);

/// Curve, law and residual; the unloading branches with their law.
void draw_fit(const press::Curve&, const FittedLaw&, const std::filesystem::path&);

} // namespace platen::app
