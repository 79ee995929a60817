#pragma once
// The law `pressed`: the curve itself at no more knots than it needs, with its unloading.

#include "fit/law_card.hpp"
#include "fit/unloading.hpp"
#include "platen/law/pressed.hpp"

#include <string_view>

namespace platen::fit {

/// How far the law is from the curve that it was made from.
struct PressedErrors {
  double relative_l2 = 0; ///< of the force over the loading
  double worst = 0;       ///< largest relative error of the force from delta_bar = 0.005 on
  double radius = 0;      ///< relative L2 of the contact radius; 0 where the curve has none
  double r_squared = 0;   ///< of the force, where it is not above zero too
  double unload_work = 0; ///< largest error of the work that an unloading branch gives back, over that work
};

struct PressedFit {
  law::PressedMaterial material;
  bool radius_measured = true; ///< false: of the force alone, see fit_pressed
  PressedErrors errors;
  double residual =
      0; ///< root mean square of what smoothing took off the force, relative; 0: a curve that rises
};

/// Knots are set where the law misses the curve most, until it is within 0.3 % in force and 0.7 % in radius,
/// or there are 64. A measured force that falls here and there is made to rise first (isotonic regression),
/// with its residual. Where the curve has no contact radius: a^2 = x (2 - x_Hertz/x), x_Hertz the overlap at
/// which Hertz carries the force: Hertz's circle where it is elastic, the cut of the sphere where it is
/// plastic. Throws core::InvalidInput where elasticity or the reference stress is missing, or there are fewer
/// than 8 points.
PressedFit fit_pressed(const press::Curve&, const UnloadingFits&);

LawCard law_card(const press::Curve&, const PressedFit&, std::string_view curve_text);

} // namespace platen::fit
