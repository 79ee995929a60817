#pragma once
// Two bodies in contact, reduced to what a law needs. Derivation: docs/explanation/dissimilar-spheres.md.
//
// Every law here was found for two equal spheres, or what is the same, one sphere on a rigid plane. With
//   A = 1/R1 + 1/R2,   B = 1/R1^3 + 1/R2^3,   1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2
// the gap between any two spheres is A r^2/2 + B r^4/8, so that the equal pair of radius
//   R_e = sqrt(A/B)  pressed to  x = gamma B/A^2  (its delta/R = gamma/2R)
// has the same contact radius, R_e a_bar(x), to both orders of curvature. Two equal spheres have R_e = R and
// x = gamma/2R; a sphere on a plane has R_e = R and x = gamma/R.

#include "platen/law/error.hpp"
#include "platen/law/macros.hpp"

#include <cmath>
#include <numbers>

namespace platen::law {

/// One side of a contact. Curvature 0 is a plane, compliance 0 a rigid body.
template <class Real = double> struct BasicBody {
  Real curvature{};  ///< 1/R [1/m]
  Real compliance{}; ///< 1/E [1/Pa]
  Real nu{};         ///< Poisson's ratio, in [0, 0.5)
};

using Body = BasicBody<double>;

inline Body sphere(double R, double E, double nu) { return {1 / R, 1 / E, nu}; }
inline Body plane(double E, double nu) { return {0, 1 / E, nu}; }
inline Body rigid_plane() { return {}; }

template <class Real = double> struct BasicPair {
  BasicBody<Real> body[2];
  Real A{};           ///< 1/R1 + 1/R2 [1/m]
  Real B{};           ///< 1/R1^3 + 1/R2^3 [1/m^3]
  Real E_star{};      ///< contact modulus of the pair [Pa]
  Real R_e{};         ///< radius of the equivalent equal pair [m]
  Real x_per_gamma{}; ///< B/A^2 [1/m]

  /// Radius over R_e of two equal spheres, A R_e = 2; of a sphere and a plane it is 1. [-]
  [[nodiscard]] PLATEN_FUNCTION Real sharing() const { return A * R_e; }

  /// Slope with which an elastic pair starts to unload from contact radius a [N/m]. The second term is what a
  /// sphere is stiffer than a half-space (Tatara's f); `finite_size` in [0, 1] fades it in.
  [[nodiscard]] PLATEN_FUNCTION Real unloading_slope(const Real& a, const Real& finite_size = Real(1)) const {
    using std::sqrt;
    Real compliance(0);
    for (const BasicBody<Real>& side : body) {
      const Real s2 = side.curvature * side.curvature * a * a + Real(4);
      const Real s = sqrt(s2);
      const Real one_minus_nu2 = Real(1) - side.nu * side.nu;
      const Real f = side.curvature * (Real(2) * (Real(1) + side.nu) / (s2 * s) + one_minus_nu2 / s);
      compliance = compliance + side.compliance * (one_minus_nu2 / (Real(2) * a) -
                                                   finite_size * f / Real(std::numbers::pi));
    }
    return Real(1) / compliance;
  }
};

using Pair = BasicPair<double>;

/// The curve of a flattened sphere holds so far (in x) for a body that is flatter than a harder partner, as a
/// plane that a hard sphere dents: the pressure of a flattened sphere falls as its contact grows, that of a
/// dent does not. Here H of Jackson & Green, 2.84 sigma_y (1 - exp(-0.82 (a/R)^-0.7)), has lost 8 %.
inline constexpr double x_dented = 0.02;

/// A softer body wraps itself around a harder sphere, and from this approach over that one's radius on
/// carries less than a flattened one (docs/explanation/joined.md).
inline constexpr double approach_wrapped = 0.4;

/// To where in x the curve of a flattened sphere, made to `x_valid`, holds between bodies of these strengths;
/// within a twentieth of each other they count as equal.
inline double flattened_to(double x_valid, const Pair& pair, double one, double two) {
  if (one <= 1.05 * two && two <= 1.05 * one) return x_valid;
  const double c_harder = pair.body[two < one ? 0 : 1].curvature, c_softer = pair.A - c_harder;
  const double x =
      c_softer < c_harder * (1 - 1e-9) ? x_dented : approach_wrapped / c_harder * pair.x_per_gamma;
  return x < x_valid ? x : x_valid;
}

/// From which overlap on, up to `end`, the force(gamma) of a law without an elastic beginning is no more than
/// Hertz's: below, it is more than the bodies can carry. infinity: it is more up to the end. [m]
template <class Force> double below_hertz_from(const Pair& pair, double end, const Force& force) {
  const auto below = [&](double gamma) {
    return force(gamma) <= 4.0 / 3 * pair.E_star * gamma * std::sqrt(gamma / pair.A);
  };
  double low = 0, high = end * 0x1p-40;
  for (; !below(high); high *= 1.1) {
    low = high;
    if (high >= end) return infinity;
  }
  for (int i = 0; low > 0 && i < 50; ++i) {
    const double middle = std::sqrt(low * high);
    (below(middle) ? high : low) = middle;
  }
  return low > 0 ? high : 0;
}

inline Pair make_pair(const Body& one, const Body& two) {
  for (const Body& side : {one, two}) {
    require("contact", "1/R", side.curvature, non_negative);
    require("contact", "1/E", side.compliance, non_negative);
    require("contact", "nu", side.nu, poisson);
  }
  const auto cube = [](double v) { return v * v * v; };
  const double compliance = (1 - one.nu * one.nu) * one.compliance + (1 - two.nu * two.nu) * two.compliance;
  Pair pair{{one, two}};
  pair.A = one.curvature + two.curvature;
  pair.B = cube(one.curvature) + cube(two.curvature);
  require("contact", "1/R1 + 1/R2", pair.A, positive);     // at least one sphere
  require("contact", "1/R1^3 + 1/R2^3", pair.B, positive); // of a size that numbers hold
  require("contact", "compliance of the pair", compliance, positive);
  pair.E_star = 1 / compliance;
  pair.R_e = std::sqrt(pair.A / pair.B);
  pair.x_per_gamma = pair.B / (pair.A * pair.A);
  return pair;
}

} // namespace platen::law
