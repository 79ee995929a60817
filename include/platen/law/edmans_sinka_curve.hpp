#pragma once
// The loading curve (6) of Edmans & Sinka and its variants, dimensionless; the law itself is
// edmans_sinka.hpp.

#include "platen/law/contact.hpp"

#include <vector>

namespace platen::law {

enum class EdmansSinkaVariant : unsigned char {
  published,  ///< (6) as printed: continuous, with a kink at delta_t
  c1,         ///< (6) with the kink rounded by a cubic over delta_t (1 -+ corner)
  hertz_like, ///< first branch k delta_t (x/delta_t)^(3/2), as the paper's Appendix A suggests
};

/// The loading curve in dimensionless form. Templated on the scalar so that a fit can differentiate it with
/// respect to x and to every parameter.
template <class Real = double> struct EdmansSinkaCurve {
  Real k{};                ///< initial slope dF_bar/dx; for hertz_like the secant slope up to delta_t [-]
  Real delta_t{};          ///< where the first branch ends, in delta/R [-]
  Real a{};                ///< rate of the exponential branch [-]
  Real corner = Real(0.5); ///< half-width of the rounded corner over delta_t; used by c1 only, in (0, 1)
  EdmansSinkaVariant variant = EdmansSinkaVariant::published;

  static constexpr double x_valid = 0.5; ///< the simulations end here
  static constexpr double x_end = 1.0;   ///< from here on the tangent continues the curve

  struct Point {
    Real F_bar, slope;
  };

  [[nodiscard]] PLATEN_FUNCTION Point at(const Real& x) const {
    if (Real(x_end) < x) {
      const Point end = inside(Real(x_end));
      return {end.F_bar + end.slope * (x - Real(x_end)), end.slope};
    }
    return inside(x);
  }

  [[nodiscard]] PLATEN_FUNCTION Real F_bar(const Real& x) const { return at(x).F_bar; }
  [[nodiscard]] PLATEN_FUNCTION Real slope(const Real& x) const { return at(x).slope; }

  /// Integral of F_bar from 0 to x.
  [[nodiscard]] PLATEN_FUNCTION Real work(const Real& x) const {
    if (Real(x_end) < x) {
      const Point end = inside(Real(x_end));
      const Real h = x - Real(x_end);
      return work(Real(x_end)) + h * (end.F_bar + Real(0.5) * h * end.slope);
    }
    using std::exp, std::sqrt;
    const Real F_t = k * delta_t;
    if (variant == EdmansSinkaVariant::c1) {
      const Real x1 = corner_start(), x2 = corner_end();
      if (x <= x1) return Real(0.5) * k * x * x;
      const Point one{k * x1, k};
      const Point two = exponential(x2);
      const Real up_to_corner = Real(0.5) * k * x1 * x1;
      if (x <= x2) return up_to_corner + hermite_integral(x1, one, x2, two, x);
      return up_to_corner + hermite_integral(x1, one, x2, two, x2) + (exponential(x).F_bar - two.F_bar) / a;
    }
    const bool hertz = variant == EdmansSinkaVariant::hertz_like;
    if (x <= delta_t) {
      if (hertz) return Real(0.4) * F_t * x * x / delta_t * sqrt(x / delta_t);
      return Real(0.5) * k * x * x;
    }
    return (hertz ? Real(0.4) : Real(0.5)) * F_t * delta_t + F_t * (exp(a * (x - delta_t)) - Real(1)) / a;
  }

  /// The steepest d ln F_bar / d ln x up to x; what unloading must not fall below (contact.hpp). The branches
  /// have 1 or 3/2, then a x; the rounded corner has its own, `steepest_in_corner`.
  [[nodiscard]] PLATEN_FUNCTION Real steepest_log_slope(const Real& x, const Real& in_corner) const {
    const Real first = variant == EdmansSinkaVariant::hertz_like ? Real(1.5) : Real(1);
    const bool rounded = variant == EdmansSinkaVariant::c1;
    const Real n = rounded && corner_start() < x ? larger(first, in_corner) : first;
    return (rounded ? corner_end() : delta_t) < x ? larger(n, a * smaller(x, Real(x_end))) : n;
  }

  /// On a cubic of known ends 64 points are enough, with a margin.
  [[nodiscard]] PLATEN_FUNCTION Real steepest_in_corner() const {
    Real n(1);
    for (int i = 1; i <= 64; ++i) {
      const Real x = corner_start() + (corner_end() - corner_start()) * Real(i) / Real(64);
      const Point p = inside(x);
      n = larger(n, Real(1.001) * x * p.slope / p.F_bar);
    }
    return n;
  }

  /// Where the formula changes.
  [[nodiscard]] std::vector<Real> kinks() const {
    if (variant == EdmansSinkaVariant::c1) return {corner_start(), corner_end()};
    return {delta_t};
  }

 private:
  [[nodiscard]] PLATEN_FUNCTION Real corner_start() const { return delta_t * (Real(1) - corner); }
  [[nodiscard]] PLATEN_FUNCTION Real corner_end() const { return delta_t * (Real(1) + corner); }

  [[nodiscard]] PLATEN_FUNCTION Point exponential(const Real& x) const {
    using std::exp;
    const Real F = k * delta_t * exp(a * (x - delta_t));
    return {F, a * F};
  }

  [[nodiscard]] PLATEN_FUNCTION Point inside(const Real& x) const {
    using std::sqrt;
    switch (variant) {
    case EdmansSinkaVariant::c1:
      if (corner_end() < x) return exponential(x);
      if (corner_start() < x)
        return hermite(corner_start(), {k * corner_start(), k}, corner_end(), exponential(corner_end()), x);
      return {k * x, k};
    case EdmansSinkaVariant::hertz_like:
      if (delta_t < x) return exponential(x);
      {
        const Real root = sqrt(x / delta_t);
        return {k * x * root, Real(1.5) * k * root};
      }
    default:
      if (delta_t < x) return exponential(x);
      return {k * x, k};
    }
  }

  [[nodiscard]] static PLATEN_FUNCTION Point hermite(const Real& x1, const Point& p1, const Real& x2,
                                                     const Point& p2, const Real& x) {
    const Real h = x2 - x1, t = (x - x1) / h, rise = p2.F_bar - p1.F_bar;
    const Real c2 = Real(3) * rise - h * (Real(2) * p1.slope + p2.slope);
    const Real c3 = h * (p1.slope + p2.slope) - Real(2) * rise;
    return {p1.F_bar + t * (h * p1.slope + t * (c2 + t * c3)),
            p1.slope + t * (Real(2) * c2 + Real(3) * t * c3) / h};
  }

  [[nodiscard]] static PLATEN_FUNCTION Real hermite_integral(const Real& x1, const Point& p1, const Real& x2,
                                                             const Point& p2, const Real& x) {
    const Real h = x2 - x1, t = (x - x1) / h, rise = p2.F_bar - p1.F_bar;
    const Real c2 = Real(3) * rise - h * (Real(2) * p1.slope + p2.slope);
    const Real c3 = h * (p1.slope + p2.slope) - Real(2) * rise;
    return h * t * (p1.F_bar + t * (h * p1.slope / Real(2) + t * (c2 / Real(3) + t * c3 / Real(4))));
  }
};

} // namespace platen::law
