#pragma once
// Curves on a common grid: few rows a run, so that the curves of many runs can be kept and compared.

#include "press/curve.hpp"

#include <optional>
#include <span>
#include <vector>

namespace platen::study {

/// One contact: force over pi R0^2 sigma_ref, contact radius over R0.
struct Contact {
  double F_bar = 0, a_bar = 0;
};

struct GridPoint {
  int branch_id = 0;
  press::Branch branch = press::Branch::loading;
  double delta_bar = 0;
  Contact z;                   ///< with the plane that presses
  std::optional<Contact> x, y; ///< with walls, where there are forces on them of their own
};

/// A loading branch at the multiples of `step` (delta/R0) up to its end, and at 1/8, 1/4 and 1/2 of it; an
/// unloading or reloading branch at the ends of twenty even parts of the way on which it is loaded. Between
/// the steps of the press by monotone cubics. A branch whose overlap turns (triaxial) stands there step by
/// step.
std::vector<GridPoint> on_grid(const press::Curve&, double step);

/// The largest difference of two curves of one case, over the largest value of its column, on a grid of
/// twenty steps. Infinity where they have other branches or ends.
double difference(const press::Curve&, const press::Curve&);

/// Monotone cubic interpolation (Fritsch & Butland 1984): no overshoot. x ascends or descends strictly, and
/// `at` lies within it.
double interpolate(std::span<const double> x, std::span<const double> y, double at);

} // namespace platen::study
