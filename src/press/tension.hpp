#pragma once
// Does the particle crack? The press has no fracture (ES section 7); it tells where tension is largest, and
// when it reaches a strength that the material card may give.

#include "press/curve.hpp"

#include <optional>
#include <string>

namespace platen::press {

/// A place on the curve.
struct Tension {
  double sigma_1_Pa = 0; ///< largest principal stress anywhere in the particle, tension positive
  double delta_bar = 0;
  Branch branch = Branch::loading;
  int branch_id = 0;
};

/// The largest tension of the press; of equal ones the first. Zero where nothing was under tension.
Tension largest_tension(const Curve&);

/// Where tension first reaches the strength (Pa, > 0), linear between the rows of the curve; loading comes
/// before the branches. Empty where it never does.
std::optional<Tension> fracture(const Curve&, double tensile_strength_Pa);

/// "largest tension 2.3e6 Pa at delta_bar = 0.12; ...": both in a sentence, without a strength the first
/// alone.
std::string tension_words(const Curve&, std::optional<double> tensile_strength_Pa);

} // namespace platen::press
