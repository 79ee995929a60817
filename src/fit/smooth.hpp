#pragma once
// How far a curve is from a smooth one: a measure of the scallops that node-wise contact leaves in a force.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace platen::fit {

/// Value at x[i] of the quadratic through the nine points i-4 … i+4 in least squares; x need not be even.
inline double quadratic_smooth(std::span<const double> x, std::span<const double> y, std::size_t i) {
  constexpr std::size_t half = 4;
  // polynomials 1, t, t^2 made orthogonal over the nine points: no normal equations to invert
  std::array<std::array<double, 2 * half + 1>, 3> basis{};
  const double scale = x[i + half] - x[i - half];
  double value = 0;
  for (std::size_t degree = 0; degree < 3; ++degree) {
    for (std::size_t j = 0; j < basis[degree].size(); ++j) {
      const double t = (x[i - half + j] - x[i]) / scale;
      basis[degree][j] = degree == 0 ? 1 : degree == 1 ? t : t * t;
    }
    for (std::size_t lower = 0; lower < degree; ++lower) {
      double product = 0, square = 0;
      for (std::size_t j = 0; j < basis[degree].size(); ++j) {
        product += basis[degree][j] * basis[lower][j];
        square += basis[lower][j] * basis[lower][j];
      }
      for (std::size_t j = 0; j < basis[degree].size(); ++j)
        basis[degree][j] -= product / square * basis[lower][j];
    }
    double product = 0, square = 0;
    for (std::size_t j = 0; j < basis[degree].size(); ++j) {
      product += basis[degree][j] * y[i - half + j];
      square += basis[degree][j] * basis[degree][j];
    }
    value += product / square * basis[degree][half];
  }
  return value;
}

/// Largest |y - smooth|/|smooth| over the points with x >= from that have four neighbours on either side; 0
/// when there is none. x ascends strictly.
inline double deviation_from_smooth(std::span<const double> x, std::span<const double> y, double from) {
  double largest = 0;
  for (std::size_t i = 4; i + 4 < x.size(); ++i) {
    if (x[i] < from) continue;
    const double smooth = quadratic_smooth(x, y, i);
    largest = std::max(largest, std::abs(y[i] - smooth) / std::abs(smooth));
  }
  return largest;
}

} // namespace platen::fit
