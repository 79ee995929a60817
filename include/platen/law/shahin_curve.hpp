#pragma once
// Rigid-plastic spheres with power-law hardening, sigma = kappa epsilon^(1/m), to large deformation,
// dimensionless: chapter 3 of Shahin's thesis, (3.45)-(3.59), with the errata noted. The law built on it is
// shahin.hpp.
//
//   F = pi R^2 kappa H_bar(x) a_bar(x)^2,  x = gamma/2R
//   a_bar = sqrt(x) (D1 e^(-0.485/m) - D3 e^(-1.455/m) x + D5 e^(-0.5279/m^0.4616) x^2)        (3.47)
//   H_bar = [H_max - p tanh(q x) cos(x - s)] x^(1/2m)                                plastic (3.48)
//   H_bar = [H_min + (1 - chi_min)/(0.467 e^(-0.5883/m)) ln(1 - X^2)] x^(1/2m)   x > x_min   (3.58)
//
// Read as: H_max = 3.101 e^(-1.748/m) everywhere, also in p and H_min (else H_bar turns negative); cos(x_min
// - s) in (3.50); (3.56) with the sum that the print lost; e^(-0.5883/m) in (3.59). Valid: 0 <= 1/m <= 1, x
// <= 0.5 (simple) and below the filled cell, where (3.58) diverges.

#include "platen/law/agarwal_curve.hpp"

namespace platen::law {

enum class ShahinVariant : unsigned char {
  published,        ///< x_min from the radius of Table 3.1 (1/m = 0)
  hardening_minimum ///< x_min from the radius (3.47) of this 1/m; the thesis does not say which
};

/// The numbers of (3.47)-(3.59) that stand for finite elements.
template <class Real = double> struct ShahinCoefficients {
  Real D1{}, D3{}, D5{}; ///< contact radius (3.47)
  Real H_max{}, q{};     ///< plastic (3.48)
  Real x_min{}, H_min{}; ///< where low compressibility begins, and the bracket of H_bar there; simple: 1, 1
  Real L{};              ///< low compressibility: 0.467 e^(-0.5883/m) (3.59)

  static PLATEN_FUNCTION ShahinCoefficients published(LoadingCase loading, const Real& inverse_m,
                                                      ShahinVariant variant) {
    using std::exp, std::pow;
    ShahinCoefficients c;
    const RadiusPolynomial<Real> limit = agarwal_radius(loading, Real(1e30)); // Table 3.1
    const Real hardening = Real(0) < inverse_m ? pow(inverse_m, Real(0.4616)) : Real(0);
    c.D1 = limit.D1 * exp(Real(-0.485) * inverse_m);
    c.D3 = limit.D3 * exp(Real(-1.455) * inverse_m);
    c.D5 = limit.D5 * exp(Real(-0.5279) * hardening);
    const RadiusPolynomial<Real> here{c.D1, c.D3, c.D5};
    c.x_min = overlap_of_least_pressure(loading, variant == ShahinVariant::published ? limit : here);
    c.H_max = Real(3.101) * exp(Real(-1.748) * inverse_m);
    c.q = Real(14.1819); // rigid-plastic limit of (2.39); that of (2.40) is r = 1
    c.H_min = least_hardness(loading, c.H_max, Real(1), c.x_min, c.q, Real(1));
    c.L = Real(0.467) * exp(Real(-0.5883) * inverse_m);
    return c;
  }
};

/// They by name, as parameters of a law card; 0 stands for the published closed form.
inline constexpr std::array<Coefficient<ShahinCoefficients<>>, 8> shahin_coefficients{{
    {"D_1", "(3.47), contact radius, with its power of e", positive, &ShahinCoefficients<>::D1},
    {"D_3", "(3.47)", finite, &ShahinCoefficients<>::D3},
    {"D_5", "(3.47)", finite, &ShahinCoefficients<>::D5},
    {"H_max", "(3.48)", positive, &ShahinCoefficients<>::H_max},
    {"q", "(3.48), softening", positive, &ShahinCoefficients<>::q},
    {"x_min",
     "(3.58), delta/R where low compressibility begins",
     {0, 1, true, false},
     &ShahinCoefficients<>::x_min},
    {"H_min", "(3.58), the bracket there", positive, &ShahinCoefficients<>::H_min},
    {"L", "(3.59), low compressibility", positive, &ShahinCoefficients<>::L},
}};

template <class Real = double> struct ShahinCurve {
  LoadingCase loading = LoadingCase::simple;
  Real inverse_m{};
  RadiusPolynomial<Real> radius; ///< (3.47)
  Real x_min{};                  ///< end of the plastic regime, gamma/2R
  Real H_max{}, p{}, H_min{};
  Softening<Real> softening;
  Real chi_min{}, g{}; ///< low compressibility: cell volume ratio at x_min; factor of the logarithm

  struct Point {
    Real F, slope; ///< F_bar = H_bar a_bar^2 and dF_bar/dx
    Real H, a, a_log_slope;
  };

  /// The published law.
  static PLATEN_FUNCTION ShahinCurve make(LoadingCase loading, const Real& inverse_m,
                                          ShahinVariant variant = ShahinVariant::published) {
    return make(loading, inverse_m, ShahinCoefficients<Real>::published(loading, inverse_m, variant));
  }

  static PLATEN_FUNCTION ShahinCurve make(LoadingCase loading, const Real& inverse_m,
                                          const ShahinCoefficients<Real>& given) {
    ShahinCurve c;
    c.loading = loading;
    c.inverse_m = inverse_m;
    c.radius = {given.D1, given.D3, given.D5};
    c.x_min = given.x_min;
    c.H_max = given.H_max;
    c.H_min = given.H_min;
    c.softening = Softening<Real>::flat_at(c.x_min, given.q, Real(1));
    c.p = (c.H_max - c.H_min) / c.softening.value(c.x_min);
    if (loading != LoadingCase::simple) {
      c.chi_min = cell_volume_ratio(loading, c.x_min);
      c.g = (Real(1) - c.chi_min) / given.L;
    }
    return c;
  }

  /// The bracket of H_bar and its slope; x^(1/2m) is the other factor.
  PLATEN_FUNCTION void bracket(const Real& x, Real& value, Real& slope) const {
    if (x <= x_min || loading == LoadingCase::simple) return plastic(x, value, slope);
    low_compressibility(x, value, slope);
  }
  PLATEN_FUNCTION void plastic(const Real& x, Real& value, Real& slope) const {
    using std::cos, std::cosh, std::sin, std::tanh;
    const Real T = tanh(softening.q * x), C = cos(x - softening.s);
    value = H_max - p * T * C;
    slope = -p * (softening.q * (Real(1) - T * T) * C - T * sin(x - softening.s));
  }
  PLATEN_FUNCTION void low_compressibility(const Real& x, Real& value, Real& slope) const {
    using std::log;
    const Real span = Real(1) - chi_min;
    const Real X = (cell_volume_ratio(loading, x) - chi_min) / span;
    const Real rest = Real(1) - X * X;
    value = H_min + g * log(rest);
    slope = Real(-2) * g * X / rest * cell_volume_ratio_slope(loading, x) / span;
  }

  [[nodiscard]] PLATEN_FUNCTION Point at(const Real& x) const {
    using std::pow;
    Point point{};
    point.a = radius.a_bar(x);
    point.a_log_slope = radius.log_slope(x);
    Real value{}, slope{};
    bracket(x, value, slope);
    const Real half = inverse_m / Real(2);
    const Real hardening = pow(x, half);
    point.H = value * hardening;
    const Real a2 = point.a * point.a;
    point.F = point.H * a2;
    point.slope = hardening * slope * a2 + point.F * (half + Real(2) * point.a_log_slope) / x;
    return point;
  }

  [[nodiscard]] PLATEN_FUNCTION Real F_bar(const Real& x) const { return at(x).F; }
};

} // namespace platen::law
