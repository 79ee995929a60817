#pragma once

#include "platen/law/contact.hpp"

#include <cmath>
#include <vector>

namespace platen::law {

/// a/R known at a few overlaps: a power of x between two of them, which the last two continue; sqrt(x) below
/// the first, as of elastic bodies, and beyond one alone. It never falls.
template <class Real = double> struct RadiusPoints {
  static constexpr int most = 8;
  int points = 0; ///< none: another formula holds
  Real x[most]{}, a[most]{}, power[most]{};

  RadiusPoints() = default;
  RadiusPoints(const double* x_, const double* a_, int points_) : points(points_) {
    for (int i = 0; i < points; ++i) x[i] = Real(x_[i]), a[i] = Real(a_[i]);
    power[0] = Real(0.5);
    for (int i = 0; i + 1 < points; ++i)
      power[i] = Real(std::log(a_[i + 1] / a_[i]) / std::log(x_[i + 1] / x_[i]));
  }

  [[nodiscard]] PLATEN_FUNCTION Real a_bar(const Real& at) const {
    using std::pow, std::sqrt;
    if (at < x[0]) return a[0] * sqrt(at / x[0]);
    int i = 0;
    while (i + 2 < points && x[i + 1] < at) ++i;
    return a[i] * pow(at / x[i], power[i]);
  }

  /// The least of d ln a / d ln x.
  [[nodiscard]] PLATEN_FUNCTION Real least_log_slope() const {
    Real least(0.5);
    for (int i = 0; i + 1 < points; ++i) least = smaller(least, power[i]);
    return least;
  }

  [[nodiscard]] std::vector<Real> kinks() const { return {x, x + points}; }
};

} // namespace platen::law
