#pragma once
// From a material to its laws: which press it takes, and what becomes of the curve.

#include "fit/fitted_law.hpp"
#include "fit/law_card.hpp"
#include "fit/pressed.hpp"
#include "press/case.hpp"
#include "press/result.hpp"

#include <optional>
#include <string>
#include <vector>

namespace platen::fit {

/// A simple press for the laws `pressed` and `edmans-sinka`: five branches unload, unless others are asked
/// for (none: the law unloads generically), and the zones are kept early, in the middle and at the end.
/// InvalidInput for more branches than a card holds, and for a case that cannot be pressed.
press::Case simple_derivation(const material::Material&, double radius_m, press::Simple,
                              const std::optional<std::vector<double>>& unload_from = {});

struct DerivedLaws {
  FittedLaw fitted; ///< edmans-sinka
  PressedFit pressed;
  LawCard fitted_card, pressed_card; ///< with the error of the press, where it was estimated
};
DerivedLaws derive_laws(const press::Result&, const std::string& variant, const Say&);

/// How far a local press goes for the law `wang`; it ends at the first limit, by default at five times the
/// overlap of first yield.
struct LocalReach {
  std::optional<double> delta_bar_max, force_max_N;
  std::optional<std::vector<double>> unload_from = {}; ///< default: four branches
};
/// InvalidInput where the material has no uniaxial strength, or yields at contacts that a local press cannot
/// resolve.
press::Case local_derivation(const material::Material&, double radius_m, const LocalReach&);

} // namespace platen::fit
