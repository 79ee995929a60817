#pragma once

#include "platen/law/macros.hpp"

namespace platen::law {

/// c0 + c1 t + c2 t^2 + c3 t^3
struct Cubic {
  double c0 = 0, c1 = 0, c2 = 0, c3 = 0;

  static Cubic hermite(double h, double f0, double d0, double f1, double d1) {
    const double rise = (f1 - f0) / h;
    return {f0, d0, (3 * rise - 2 * d0 - d1) / h, (d0 + d1 - 2 * rise) / (h * h)};
  }
  /// Through f0, f1, f2, f3 at t = 0, h/3, 2h/3, h.
  static Cubic through(double h, double f0, double f1, double f2, double f3) {
    return {f0, (-5.5 * f0 + 9 * f1 - 4.5 * f2 + f3) / h, (9 * f0 - 22.5 * f1 + 18 * f2 - 4.5 * f3) / (h * h),
            (-4.5 * f0 + 13.5 * f1 - 13.5 * f2 + 4.5 * f3) / (h * h * h)};
  }
  [[nodiscard]] PLATEN_HOT double value(double t) const { return (c0 + t * c1) + t * t * (c2 + t * c3); }
  [[nodiscard]] PLATEN_HOT double slope(double t) const { return c1 + t * (2 * c2 + 3 * t * c3); }
  [[nodiscard]] PLATEN_HOT double integral(double t) const {
    return t * (c0 + t * (c1 * 0.5 + t * (c2 * (1.0 / 3) + t * c3 * 0.25)));
  }
};

} // namespace platen::law
