#pragma once
// What `fit` and `derive` make of a curve: the published form with its unloading.

#include "fit/contact_radius.hpp"
#include "fit/edmans_sinka.hpp"
#include "fit/unloading.hpp"
#include "press/curve.hpp"

#include <functional>
#include <string>

namespace platen::fit {

/// Given what the user must read, a sentence each, "note: ...".
using Say = std::function<void(const std::string&)>;

struct FittedLaw {
  EdmansSinkaFit loading;
  ContactRadius radius;
  UnloadingFits unloading;
  std::string verdict; ///< which form fits best, and by how much; empty where the form was given
};

/// InvalidInput unless `variant` is a form to fit, or "best"; to be asked before a press.
void check_variant(const std::string& variant);

/// The curve's unloading branches, as all laws have them. Those that cannot be fitted are named.
UnloadingFits unloading_of(const press::Curve&, const Say&);

/// Loading and unloading branches of the curve.
FittedLaw fit_law(const press::Curve&, const std::string& variant, const Say&);

} // namespace platen::fit
