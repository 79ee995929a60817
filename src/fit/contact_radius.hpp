#pragma once
// What the law edmans-sinka keeps of the contact radius of a press.

#include "press/curve.hpp"

#include <vector>

namespace platen::fit {

struct ContactRadius {
  std::vector<double> delta_bar, a_bar; ///< at most eight points, powers of delta_bar between them
  double relative_l2 = 0;               ///< over the loading from the first point on
  double largest = 0;                   ///< relative error at any row there
};

/// Least squares in ln a over ln delta_bar, from a hundredth of the largest overlap on; a radius that falls
/// is held level. Nothing where the curve has no contact radius.
ContactRadius fit_contact_radius(const press::Curve&);

} // namespace platen::fit
