#pragma once
// Fit of the unloading law (9)-(14) of Edmans & Sinka to the unloading branches of a press:
//   F_bar = F_max ((delta - delta_0)/(delta_max - delta_0))^alpha,  delta > delta_0;  0 below          (13)
// with alpha and delta_0 free, by least squares in delta_bar (trapezoid weights).

#include "press/curve.hpp"

#include <string>
#include <vector>

namespace platen::fit {

struct UnloadingFit {
  int branch_id = 0;
  double delta_bar_max = 0; ///< where the branch leaves the loading curve
  double F_bar_max = 0;     ///< there
  double alpha = 0;         ///< exponent, in [1, 10]; 3/2 for Hertz
  double delta_bar_0 = 0;   ///< overlap at separation, not below 0
  double beta = 0;          ///< secant stiffness over Hertz's (11)
  double k = 0;             ///< (14)
  double r_squared = 0;     ///< zeros after separation are left out: they would flatter it
  double rmse = 0;          ///< root of the mean square of F_bar - law over delta_bar
  std::size_t points = 0;   ///< fitted, the turning point and the first zero among them

  double F_bar(double delta_bar) const;
};

struct UnloadingFits {
  std::vector<UnloadingFit> fits;   ///< ascending in delta_bar_max
  std::vector<std::string> skipped; ///< a sentence for each branch that is too short to be fitted
};

/// Fits every unloading branch. A branch starts at its turning point, or with the step after it; then the
/// turning point is the next point of the loading branch. Throws core::InvalidInput when E, nu or sigma_ref
/// are missing (beta needs them) or a branch is not finite or not descending.
UnloadingFits fit_unloading(const press::Curve&);

} // namespace platen::fit
