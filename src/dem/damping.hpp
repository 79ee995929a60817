#pragma once
// Viscous damping for a restitution coefficient. Codes that take a law as text (device_law.cpp) take this
// function with it: it is compiled and quoted from here.

#include <cmath>

#define PLATEN_COMPILED_AND_QUOTED(name, ...)                                                                \
  inline __VA_ARGS__ inline constexpr const char* name = #__VA_ARGS__;

namespace platen::dem {

// `damping` with which a Hertzian contact returns e, in (0, 1], at any velocity: the viscous coefficient is
// c = damping sqrt(dF/dgamma m), the force max(F - c v, 0).
//
// In w = gamma^(5/4) the impact is that of a linear spring with damping ratio zeta = sqrt(3/10) damping, and
// its force ends where a linear spring's does: there e = exp(-2 zeta A), A = acos(zeta)/sqrt(1 - zeta^2),
// beyond 1 acosh(zeta)/sqrt(zeta^2 - 1) (Schwager & Poschel, Granular Matter 9 (2007) 465). Newton's method;
// zeta A is concave, and at most pi/2 zeta and 1 + acosh(zeta), which is where it starts.
// clang-format off
PLATEN_COMPILED_AND_QUOTED(damping_text, double platen_damping_of(double e) {
  const double half = (0 - log(e)) / 2;
  double zeta = half > 1 ? cosh(half - 1) : half * 2 / 3.14159265358979323846;
  for (int k = 0; k < 8; ++k) {
    const double r = 1 - zeta * zeta;
    const bool critical = fabs(r) < 1e-6;
    const double A = critical ? 1 + r / 6 : r > 0 ? acos(zeta) / sqrt(r) : acosh(zeta) / sqrt(-r);
    zeta -= (zeta * A - half) / (critical ? 2.0 / 3 : (A - zeta) / r);
  }
  return sqrt(10.0 / 3) * zeta;
})
// clang-format on

} // namespace platen::dem
