#pragma once
// Elastic, perfectly plastic spheres to large deformation, dimensionless: Agarwal, Shahin & Gonzalez, chapter
// 2 of Shahin's thesis, (2.12)-(2.48), with the errata noted. The law built on it is agarwal.hpp.
//
//   F = pi R^2 sigma_y H_bar(x) a_bar(x)^2,  x = gamma/2R,  lambda = E/((1 - nu^2) sigma_y),  zeta =
//   B/sigma_y a_bar = sqrt(x) (D1 - D3 x + D5 x^2)                                                     (2.13)
//   H_bar: elastic | elastic-plastic | plastic | low compressibility | elastic volumetric    (2.48)
//          0     x_y              x_h        x_min               x_zp
//
// Valid: lambda >= 22.1 (c2 >= 1), calibrated for 117..5933; x <= 0.5 (simple), a little past the filled cell
// otherwise. Force is unreliable below x of about 0.05 with the published radius: it is not Hertz's, the
// elastic limit is 2.2 to 3.1 times Hertz's force.

#include "platen/law/coefficient.hpp"
#include "platen/law/contact.hpp"
#include "platen/law/loading_case.hpp"
#include "platen/law/radius_polynomial.hpp"

namespace platen::law {

enum class AgarwalVariant : unsigned char {
  published,    ///< (2.13) everywhere
  hertz_radius, ///< ours: a = sqrt(gamma/A) up to x_y, joining (2.13) at x_joined; F is exactly Hertz's up
                ///< to x_y
};

/// Where the minimum of H_bar in the cell is looked for: rho_V rho_S = 0.0593 (2.28).
inline constexpr double shahin_minimum_density_product = 0.0593;

/// rho_V rho_S of a contact along z (2.28)-(2.30): die pi^2 a^2/(144 (1 - x)), hydrostatic with (1 - x)^5.
inline double density_product(LoadingCase loading, double x, double a_bar) {
  const double h = 1 - x;
  return std::numbers::pi * std::numbers::pi / 144 * a_bar * a_bar /
         (loading == LoadingCase::die ? h : h * h * h * h * h);
}
/// The same of a side contact in a die, over the primary overlap (2.52).
inline double side_density_product(double x, double a_bar) {
  return std::numbers::pi * std::numbers::pi / 144 * a_bar * a_bar / ((1 - x) * (1 - x));
}

/// b_i^LC and (alpha, beta, delta)_i of Table 2.2, i = 1, 3, 5. The exponent of b is i/2, not 1/2 as printed
/// in (2.14): only so does Table 3.1 follow.
template <class Real>
PLATEN_FUNCTION RadiusPolynomial<Real> agarwal_radius(LoadingCase loading, const Real& lambda) {
  using std::pow, std::tanh;
  constexpr double b[3][3] = {{1, 1, 1}, {1.048, 1.1818, 1.2352}, {1.1701, 2.4002, 2.9376}};
  const double* bi = b[static_cast<int>(loading)];
  const auto D = [&](double bi_, double i, double alpha, double beta, double delta) {
    return Real(pow(bi_, i / 2) * alpha) * tanh(Real(beta) * pow(lambda, Real(delta)));
  };
  return {D(bi[0], 1, 1.7527, 0.3540, 0.2633), D(bi[1], 3, 2.3702, 0.0411, 0.5366),
          D(bi[2], 5, 3.3715, 0.0634, 0.4766)};
}

/// The rigid-plastic limit of the above, lambda -> infinity: Table 3.1 (D5 of HC is 49.866; 39.8654 is a
/// misprint).
inline RadiusPolynomial<double> rigid_plastic_radius(LoadingCase loading) {
  return agarwal_radius(loading, 1e30);
}

/// The overlap x_min at which the contact pressure is least: appendix C, density_product() = Gamma. The left
/// side rises from 0, so there is one root; simple loading has x_min = 1.
template <class Real>
PLATEN_FUNCTION Real overlap_of_least_pressure(LoadingCase loading, const RadiusPolynomial<Real>& radius) {
  if (loading == LoadingCase::simple) return Real(1);
  const Real target(144 * shahin_minimum_density_product / (std::numbers::pi * std::numbers::pi));
  const bool die = loading == LoadingCase::die;
  const auto excess = [&](const Real& x) {
    const Real h = Real(1) - x, a = radius.a_bar(x);
    return a * a - target * (die ? h : h * h * h * h * h);
  };
  Real low(0), high(1);
  for (int i = 0; i < 60; ++i) {
    const Real middle = Real(0.5) * (low + high);
    if (excess(middle) < Real(0)) low = middle;
    else high = middle;
  }
  Real x = Real(0.5) * (low + high);
  for (int i = 0; i < 2; ++i) { // Newton: the last digits, and the derivatives of a differentiating scalar
    const Real h = Real(1) - x, a = radius.a_bar(x);
    const Real slope =
        Real(2) * a * a * radius.log_slope(x) / x + target * (die ? Real(1) : Real(5) * h * h * h * h);
    x = x - excess(x) / slope;
  }
  return x;
}

/// One softening shape: [tanh(q y) cos(y - s)]^r over y = x - x_h, flat at y_min (2.25)-(2.26).
template <class Real> struct Softening {
  Real q{}, r{}, s{};

  static PLATEN_FUNCTION Softening flat_at(const Real& y_min, const Real& q, const Real& r) {
    using std::atan, std::sinh;
    return {q, r, y_min - atan(Real(2) * q / sinh(Real(2) * q * y_min))};
  }
  [[nodiscard]] PLATEN_FUNCTION Real value(const Real& y) const {
    using std::cos, std::pow, std::tanh;
    return pow(tanh(q * y) * cos(y - s), r);
  }
  /// d ln value / dy, without the factor r
  [[nodiscard]] PLATEN_FUNCTION Real log_slope(const Real& y) const {
    using std::sinh, std::tan;
    return Real(2) * q / sinh(Real(2) * q * y) - tan(y - s);
  }
  /// Approximate inflection point (2.34); r = 1 gives the corrected (3.56)
  [[nodiscard]] PLATEN_FUNCTION Real inflection() const {
    using std::sqrt, std::tan;
    const Real t = tan(s), w = Real(2) * q * q + Real(3), d = Real(2) * r + Real(1);
    const Real root = sqrt(Real(3) * w * (r - Real(1)) * d + Real(9) * (Real(2) * r * r - Real(1)) * t * t);
    return (Real(3) * r * t + root) / (w * d + Real(3) * (r + Real(1)) * t * t);
  }
  /// p of the slope at the inflection point, and its limit for an inflection at y -> 0 (r = 1, s <= 0)
  [[nodiscard]] PLATEN_FUNCTION Real slope_at_inflection() const {
    using std::cos;
    const Real y = inflection();
    if (!(Real(1e-12) < y)) return q * cos(s);
    return value(y) * r * log_slope(y);
  }
};

/// The least H_bar for one loading case (2.31)-(2.37), of a softening that is flat there.
template <class Real>
PLATEN_FUNCTION Real least_hardness(LoadingCase loading, const Real& H_max, const Real& y_simple,
                                    const Real& y_min, const Real& q, const Real& r) {
  if (loading == LoadingCase::simple) return Real(1);
  const auto here = Softening<Real>::flat_at(y_min, q, r), simple = Softening<Real>::flat_at(y_simple, q, r);
  const Real p_simple = (H_max - Real(1)) / simple.value(y_simple);                      // (2.32)
  const Real H1 = H_max - p_simple * simple.value(y_min);                                // (2.33)
  const Real p_o = p_simple * simple.slope_at_inflection() / here.slope_at_inflection(); // (2.35)
  const Real H2 = H_max - p_o * here.value(y_min);                                       // (2.36)
  return Real(0.5) * (H1 + H2);                                                          // (2.37)
}

/// The numbers of (2.48) that stand for finite elements.
template <class Real = double> struct AgarwalCoefficients {
  Real D1{}, D3{}, D5{}; ///< contact radius (2.14)
  Real x_joined{}; ///< hertz_radius: from here on the radius is (2.13); ours, three times the published x_h
  Real H_max{}, x_h{};   ///< greatest H_bar and its overlap (2.19), (2.20)
  Real q{}, r{};         ///< softening (2.39), (2.40)
  Real x_min{}, H_min{}; ///< least H_bar: where (2.28), and how much (2.37); simple loading: 1 and 1
  Real l{};              ///< low compressibility (2.47)

  static PLATEN_FUNCTION AgarwalCoefficients published(LoadingCase loading, const Real& lambda,
                                                       const Real& zeta) {
    using std::exp, std::pow, std::tanh;
    AgarwalCoefficients c;
    const RadiusPolynomial<Real> radius = agarwal_radius(loading, lambda);
    c.D1 = radius.D1, c.D3 = radius.D3, c.D5 = radius.D5;
    c.H_max = Real(3.101) * tanh(Real(0.6746) * pow(lambda, Real(0.0829)));
    c.x_h = exp(Real(0.7073) / pow(lambda, Real(0.6547))) - Real(1);
    c.x_joined = Real(3) * c.x_h;
    c.q = Real(14.1819) * tanh(Real(0.3729) * pow(lambda, Real(0.1013)));
    c.r = exp(Real(1.6199) / pow(lambda, Real(0.3232)));
    c.x_min = overlap_of_least_pressure(loading, radius);
    c.H_min = least_hardness(loading, c.H_max, Real(1) - c.x_h, c.x_min - c.x_h, c.q, c.r);
    c.l = Real(1) - Real(1) / (Real(1) + Real(0.2335) * zeta);
    return c;
  }
};

/// They by name, as parameters of a law card; 0 stands for the published closed form.
inline constexpr std::array<Coefficient<AgarwalCoefficients<>>, 11> agarwal_coefficients{{
    {"D_1", "(2.13), contact radius", positive, &AgarwalCoefficients<>::D1},
    {"D_3", "(2.13)", finite, &AgarwalCoefficients<>::D3},
    {"D_5", "(2.13)", finite, &AgarwalCoefficients<>::D5},
    {"x_joined",
     "hertz-radius: delta/R from which on the radius is (2.13)",
     {0, 1, true, true},
     &AgarwalCoefficients<>::x_joined},
    {"H_max",
     "(2.18), greatest hardness over sigma_y",
     {1.1, infinity, true, true},
     &AgarwalCoefficients<>::H_max},
    {"x_h", "(2.18), its delta/R", {0, 1, true, true}, &AgarwalCoefficients<>::x_h},
    {"q", "(2.25), softening", positive, &AgarwalCoefficients<>::q},
    {"r", "(2.25)", {1, infinity, false, true}, &AgarwalCoefficients<>::r},
    {"x_min", "(2.26), delta/R of the least hardness", {0, 1, true, false}, &AgarwalCoefficients<>::x_min},
    {"H_min", "(2.38), the least hardness over sigma_y", positive, &AgarwalCoefficients<>::H_min},
    {"l", "(2.41), low compressibility", {0, 1, true, true}, &AgarwalCoefficients<>::l},
}};

template <class Real = double> struct AgarwalCurve {
  LoadingCase loading = LoadingCase::simple;
  AgarwalVariant variant = AgarwalVariant::published;
  Real lambda{}, zeta{};
  RadiusPolynomial<Real> radius;
  Real x_y{}, x_h{}, x_min{}, x_zp{}; ///< ends of the regimes, gamma/2R
  Real H_max{}, c1{}, c2{};           ///< elastic-plastic (2.18)-(2.23)
  Softening<Real> softening;          ///< plastic (2.25)
  Real p{}, H_min{};
  Real chi_min{}, chi_zp{}, u{}, l{}; ///< low compressibility (2.41)-(2.47)
  Real x_joined{}, blend_rate{};      ///< hertz_radius: where it joins (2.13), 1/ln(x_joined/x_y)

  struct Point {
    Real F, slope; ///< F_bar = H_bar a_bar^2 and dF_bar/dx
    Real H, a, a_log_slope;
  };

  /// The published law.
  static PLATEN_FUNCTION AgarwalCurve make(LoadingCase loading, AgarwalVariant variant, const Real& lambda,
                                           const Real& zeta) {
    return make(loading, variant, lambda, zeta, AgarwalCoefficients<Real>::published(loading, lambda, zeta));
  }

  static PLATEN_FUNCTION AgarwalCurve make(LoadingCase loading, AgarwalVariant variant, const Real& lambda,
                                           const Real& zeta, const AgarwalCoefficients<Real>& given) {
    using std::log, std::pow;
    AgarwalCurve c;
    c.loading = loading;
    c.variant = variant;
    c.lambda = lambda;
    c.zeta = zeta;
    c.radius = {given.D1, given.D3, given.D5};
    const Real root_y = Real(3.3 * std::numbers::pi / 4) / lambda; // (2.17) with A = 2/R
    c.x_y = root_y * root_y;
    c.H_max = given.H_max;
    c.x_h = given.x_h;
    c.x_joined = given.x_joined;
    c.blend_rate = Real(1) / log(c.x_joined / c.x_y);
    const Real L = log(c.x_h / c.x_y);
    c.c2 = Real(0.55) * L / (c.H_max - Real(1.1)); // (2.22): lambda sqrt(A gamma_y)/(3 pi) = 1.1/2
    c.c1 = (c.H_max - Real(1.1)) / pow(L, c.c2);   // (2.23)
    c.x_min = given.x_min;
    const Real y_min = c.x_min - c.x_h;
    c.softening = Softening<Real>::flat_at(y_min, given.q, given.r);
    c.H_min = given.H_min;
    c.p = (c.H_max - c.H_min) / c.softening.value(y_min); // (2.32), (2.38)
    if (loading == LoadingCase::simple) {
      c.x_zp = Real(1);
      return c;
    }
    c.chi_min = cell_volume_ratio(loading, c.x_min);
    c.l = given.l;
    const Real k = (Real(1) - c.l) * log(Real(1) - c.l);
    const Real v_el =
        (Real(2) * c.l * c.H_min + zeta * (Real(1) - c.chi_min) * k) / (zeta * (Real(2) * c.l + k)); // (2.46)
    c.chi_zp = Real(1) - v_el;                                                                       // (2.43)
    c.u = (c.H_min - zeta * v_el) / log(Real(1) - c.l);                                              // (2.45)
    c.x_zp = x_of_cell_volume_ratio(loading, c.chi_zp);
    return c;
  }

  /// Contact radius over R, and d ln a / d ln x.
  PLATEN_FUNCTION void contact_radius(const Real& x, Real& a, Real& log_slope) const {
    using std::log, std::sqrt;
    const Real root = sqrt(x);
    if (variant == AgarwalVariant::published || x_joined <= x) {
      a = radius.a_bar(x);
      log_slope = radius.log_slope(x);
      return;
    }
    a = root;
    log_slope = Real(0.5);
    if (x <= x_y) return;
    // Smooth step in ln x between Hertz's radius and (2.13). The end, three times the published x_h, is ours:
    // it matches finite elements (von Mises, E/sigma_y = 100) at x = 0.002, 0.02 and 0.05.
    const Real t = log(x / x_y) * blend_rate;
    const Real step = t * t * (Real(3) - Real(2) * t), step_slope = Real(6) * t * (Real(1) - t) * blend_rate;
    const Real full = radius.D1 + x * (radius.D5 * x - radius.D3), excess = full - Real(1);
    const Real factor = Real(1) + step * excess;
    const Real full_slope = x * (Real(2) * radius.D5 * x - radius.D3);
    a = root * factor;
    log_slope = Real(0.5) + (step_slope * excess + step * full_slope) / factor;
  }

  /// H_bar and dH_bar/dx in the regime that holds x (2.48).
  PLATEN_FUNCTION void hardness(const Real& x, Real& H, Real& slope) const {
    if (x <= x_y) return elastic(x, H, slope);
    if (x <= x_h) return elastic_plastic(x, H, slope);
    if (x <= x_min || loading == LoadingCase::simple) return plastic(x, H, slope);
    if (x <= x_zp) return low_compressibility(x, H, slope);
    return elastic_volumetric(x, H, slope);
  }

  PLATEN_FUNCTION void elastic(const Real& x, Real& H, Real& slope) const { // (2.15)
    using std::sqrt;
    H = Real(4 / (3 * std::numbers::pi)) * lambda * sqrt(x);
    slope = H / (Real(2) * x);
  }
  PLATEN_FUNCTION void elastic_plastic(const Real& x, Real& H, Real& slope) const { // (2.18), (2.21)
    using std::log, std::pow;
    const Real L = larger(Real(0), log(x_h / x));
    const Real power = pow(L, c2 - Real(1));
    H = H_max - c1 * L * power;
    slope = c1 * c2 * power / x;
  }
  PLATEN_FUNCTION void plastic(const Real& x, Real& H, Real& slope) const { // (2.25), (2.27)
    const Real y = x - x_h;
    if (!(Real(0) < y)) {
      H = H_max;
      slope = Real(0); // r > 1
      return;
    }
    const Real drop = p * softening.value(y);
    H = H_max - drop;
    slope = -drop * softening.r * softening.log_slope(y);
  }
  PLATEN_FUNCTION void low_compressibility(const Real& x, Real& H, Real& slope) const { // (2.41)
    using std::log;
    const Real span = chi_zp - chi_min;
    const Real X = (cell_volume_ratio(loading, x) - chi_min) / span;
    const Real rest = Real(1) - l * X * X;
    H = H_min - u * log(rest);
    slope = Real(2) * u * l * X / rest * cell_volume_ratio_slope(loading, x) / span;
  }
  PLATEN_FUNCTION void elastic_volumetric(const Real& x, Real& H, Real& slope) const { // (2.44)
    H = zeta * (Real(1) - cell_volume_ratio(loading, x));
    slope = -zeta * cell_volume_ratio_slope(loading, x);
  }

  [[nodiscard]] PLATEN_FUNCTION Point at(const Real& x) const {
    Point point{};
    Real H_slope{};
    contact_radius(x, point.a, point.a_log_slope);
    hardness(x, point.H, H_slope);
    const Real a2 = point.a * point.a;
    point.F = point.H * a2;
    point.slope = H_slope * a2 + Real(2) * point.F * point.a_log_slope / x;
    return point;
  }

  [[nodiscard]] PLATEN_FUNCTION Real F_bar(const Real& x) const { return at(x).F; }
};

} // namespace platen::law
