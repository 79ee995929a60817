#pragma once
// A perceptually uniform scale of colours and its bar.

#include "plot/scene.hpp"

#include <string>
#include <vector>

namespace platen::plot {

/// Steps of colour between the ends of the scale: fine enough to look smooth, coarse enough for small files.
inline constexpr int levels = 48;

/// viridis as "#rrggbb", one a level.
std::vector<std::string> viridis();

/// The values at the ends of a scale.
struct Range {
  double low, high;
  int level(double value) const; ///< held at the ends
};

/// Smallest range with ends of two digits or so that holds all values.
Range round_range(double low, double high);

/// A bar with three numbers under it and the name beside it; returns the y of its lower end.
double colour_bar(Scene&, Point at, const std::string& name, Range);

} // namespace platen::plot
