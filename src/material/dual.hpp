#pragma once
// Numbers that carry their derivatives in s and phi along, for yield curves too long to differentiate by
// hand.

#include <cmath>

namespace platen::material {

struct Dual {
  double x = 0, s = 0, phi = 0; ///< value, d/ds, d/d(phi)

  /// f(x) with its slope.
  Dual chain(double value, double slope) const { return {value, slope * s, slope * phi}; }
};

inline Dual operator+(Dual a, Dual b) { return {a.x + b.x, a.s + b.s, a.phi + b.phi}; }
inline Dual operator-(Dual a, Dual b) { return {a.x - b.x, a.s - b.s, a.phi - b.phi}; }
inline Dual operator*(Dual a, Dual b) {
  return {a.x * b.x, a.s * b.x + a.x * b.s, a.phi * b.x + a.x * b.phi};
}
inline Dual operator/(Dual a, Dual b) {
  const double x = a.x / b.x;
  return {x, (a.s - x * b.s) / b.x, (a.phi - x * b.phi) / b.x};
}
inline Dual operator-(Dual a) { return {-a.x, -a.s, -a.phi}; }
inline Dual operator+(double a, Dual b) { return {a + b.x, b.s, b.phi}; }
inline Dual operator-(double a, Dual b) { return {a - b.x, -b.s, -b.phi}; }
inline Dual operator*(double a, Dual b) { return {a * b.x, a * b.s, a * b.phi}; }
inline Dual operator/(double a, Dual b) { return Dual{a, 0, 0} / b; }
inline Dual sqrt(Dual a) {
  const double root = std::sqrt(a.x);
  return a.chain(root, 0.5 / root);
}
inline Dual sin(Dual a) { return a.chain(std::sin(a.x), std::cos(a.x)); }
inline Dual cos(Dual a) { return a.chain(std::cos(a.x), -std::sin(a.x)); }

} // namespace platen::material
