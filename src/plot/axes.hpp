#pragma once
// Units and ticks of the axes of a curve.

#include "press/curve.hpp"

#include <string>
#include <vector>

namespace platen::plot {

inline constexpr const char* ink = "#1f2933"; ///< of words and axes

struct Unit {
  const char* name;
  double in_SI;
};

/// The largest unit of the list, descending, in which the value is at least 1.
Unit unit_for(double value, const std::vector<Unit>& units);

/// A tick distance of 1, 2 or 5 times a power of ten, with `wanted` ticks at most.
double tick(double range, int wanted);

/// Commands for second axes of delta and F in SI units, where the curve says its radius and reference stress;
/// x_max and y_max are the ends of the dimensionless axes.
std::string second_axes(const press::Curve&, double x_max, double y_max);

} // namespace platen::plot
