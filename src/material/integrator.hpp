#pragma once
// The one implicit integrator: return of a trial elastic strain to the yield surface, in (p, q).
//
// The trial Hencky strain enters by its invariants eps_v and eps_q. Backward Euler on the flow rule, with the
// surface and the moduli at the new state (Edmans & Sinka's fully implicit scheme):
//
//   eps_v = eps_v^tr - dv,   eps_q = eps_q^tr - dw,   phi = phi_n + phi_rate (dv, dw)
//   K(phi) eps_v e^{-eps_v}   = p(s, phi)
//   3G(phi) eps_q e^{-eps_v}  = q(s, phi)
//   n_q(s, phi) dv - n_p(s, phi) dw = 0
//
// for (s, dv, dw). The moduli relate Hencky strain to stress on the intermediate (unloaded) volume, so that
// elasticity derives from an energy; e^{-eps_v} = 1/J_e makes it the Cauchy stress, in which the material
// yields.
//
// Newton with line search starts from the model's first guess, or, where that fails, from the closest point
// of the surface frozen at phi_n, found by bisection. Where that fails too, phi is bracketed outside and the
// closest point of the then frozen surface inside, and Newton polishes.

#include "material/plasticity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

namespace platen::material {

/// Relative residual of the local equations at which a return counts as converged. Newton is quadratic there,
/// so that the state is exact to rounding.
inline constexpr double relative_return_tolerance = 1e-12;

namespace detail {

/// A trial with what every attempt needs of it.
template <class T> struct TrialOf : TrialInvariantsOf<T> {
  T exp_v; ///< e^{-eps_v}
};
using Trial = TrialOf<double>;

template <class T> using Triple = std::array<T, 3>;

/// Residual and Jacobian of the return at (s, dv, dw), stresses times `unit` = 1/(3G(phi_n)).
template <class T> struct ReturnOf {
  Triple<T> r;
  std::array<Triple<T>, 3> J;
  SurfacePointOf<T> at;
  ModuliOf<T> moduli;
  std::conditional_t<std::is_same_v<T, double>, Zone, T> zone; ///< of lanes its number
  T s, s_min, s_max;                                           ///< of the surface at phi
  T phi, eps_v, eps_q;
  T exp_v; ///< e^{-eps_v}

  T merit() const { return r[0] * r[0] + r[1] * r[1] + r[2] * r[2]; }
};
using Return = ReturnOf<double>;

template <InvariantModel M, class T>
ReturnOf<T> evaluate_return(const M& model, const TrialOf<T>& trial, const T& phi_n, const T& unit,
                            const Triple<T>& x) {
  using std::exp, core::exp;
  const auto& [s, dv, dw] = x;
  constexpr PhiRate rate = M::phi_rate;
  ReturnOf<T> e;
  e.s = s;
  e.phi = phi_n + rate.v * dv + rate.w * dw;
  e.eps_v = trial.eps_v - dv;
  e.eps_q = trial.eps_q - dw;
  if constexpr (std::is_same_v<T, double>) e.exp_v = dv == 0 ? trial.exp_v : exp(-e.eps_v);
  else e.exp_v = exp(-e.eps_v);
  const auto [moduli, surface] = properties(model, e.phi);
  e.moduli = moduli;
  e.at = surface.at(s);
  e.zone = surface.zone(s);
  e.s_min = surface.s_min();
  e.s_max = surface.s_max();
  const auto& [K, G, K_phi, G_phi] = e.moduli;
  const auto& f = e.at;
  e.r = {(K * e.eps_v * e.exp_v - f.p) * unit, (3 * G * e.eps_q * e.exp_v - f.q) * unit,
         f.n_q * dv - f.n_p * dw};
  const T p_phi = K_phi * e.eps_v * e.exp_v - f.p_phi, q_phi = 3 * G_phi * e.eps_q * e.exp_v - f.q_phi;
  const T n_phi = f.n_q_phi * dv - f.n_p_phi * dw;
  e.J[0] = {-f.p_s * unit, (-K * (1 - e.eps_v) * e.exp_v + p_phi * rate.v) * unit, p_phi * rate.w * unit};
  e.J[1] = {-f.q_s * unit, (3 * G * e.eps_q * e.exp_v + q_phi * rate.v) * unit,
            (-3 * G * e.exp_v + q_phi * rate.w) * unit};
  e.J[2] = {f.n_q_s * dv - f.n_p_s * dw, f.n_q + n_phi * rate.v, -f.n_p + n_phi * rate.w};
  return e;
}

/// Cofactors of a 3x3 matrix, and its determinant: solve(b) = A^-1 b.
template <class T> struct Inverse3Of {
  std::array<Triple<T>, 3> c;
  T det, per_det;
  explicit Inverse3Of(const std::array<Triple<T>, 3>& a) {
    c[0] = {a[1][1] * a[2][2] - a[1][2] * a[2][1], a[0][2] * a[2][1] - a[0][1] * a[2][2],
            a[0][1] * a[1][2] - a[0][2] * a[1][1]};
    c[1] = {a[1][2] * a[2][0] - a[1][0] * a[2][2], a[0][0] * a[2][2] - a[0][2] * a[2][0],
            a[0][2] * a[1][0] - a[0][0] * a[1][2]};
    c[2] = {a[1][0] * a[2][1] - a[1][1] * a[2][0], a[0][1] * a[2][0] - a[0][0] * a[2][1],
            a[0][0] * a[1][1] - a[0][1] * a[1][0]};
    det = a[0][0] * c[0][0] + a[0][1] * c[1][0] + a[0][2] * c[2][0];
    per_det = 1 / det;
  }
  Triple<T> solve(const Triple<T>& b) const {
    Triple<T> x;
    for (int i = 0; i < 3; ++i) x[i] = (c[i][0] * b[0] + c[i][1] * b[1] + c[i][2] * b[2]) * per_det;
    return x;
  }
};
using Inverse3 = Inverse3Of<double>;

/// eps_v of K eps_v e^{-eps_v} = p on the branch through zero; NaN where p exceeds the elastic limit K/e.
inline double volumetric_strain(double p, double K) {
  double x = p / K;
  if (!(x < 1 / std::exp(1.0))) return std::numeric_limits<double>::quiet_NaN();
  const double y = x;
  x = y < 0 ? -std::log1p(-y) : y * (1 + y);
  for (int i = 0; i < 60; ++i) {
    const double f = x - y * std::exp(x), f_x = 1 - y * std::exp(x);
    const double dx = f / f_x;
    x -= dx;
    if (std::abs(dx) <= 1e-15 * (1 + std::abs(x))) break;
  }
  return x;
}

/// The closest-point return at frozen phi by bisection in s, from s = 0, where pieces of a surface meet; no
/// flow where the trial is not outside.
template <InvariantModel M>
[[gnu::noinline]] std::array<double, 3> frozen_return(const M& model, TrialInvariants trial, double phi,
                                                      int bisections) {
  const auto [m, surface] = properties(model, phi);
  const double exp_v = std::exp(-trial.eps_v);
  if (surface.contains(m.K * trial.eps_v * exp_v, 3 * m.G * trial.eps_q * exp_v)) return {};
  double lo = surface.s_min(), hi = surface.s_max(), s = 0;
  std::array<double, 3> x{};
  for (int i = 0; i < bisections; ++i, s = (lo + hi) / 2) {
    const SurfacePoint f = surface.at(s);
    const double eps_v = volumetric_strain(f.p, m.K);
    const double dv = trial.eps_v - eps_v, dw = trial.eps_q - f.q / (3 * m.G) * std::exp(eps_v);
    x = {s, dv, dw};
    // Where the remaining increment lies on the tensile side of the normal, move towards the tensile end. A
    // trial with less q than here lies there if it is more tensile: normals that look away from the trial
    // would lead to roots behind the surface.
    const bool tensile = dw < 0 ? dv > 0 : f.n_q * dv - f.n_p * dw > 0;
    (tensile ? hi : lo) = s;
  }
  return x;
}

/// Start values for Newton from a bracket in phi; false where there is none.
template <InvariantModel M>
[[gnu::noinline]] bool bracketed_start(const M& model, TrialInvariants trial, double phi_n,
                                       std::array<double, 3>& x) {
  constexpr PhiRate rate = M::phi_rate;
  const auto gap = [&](double phi) {
    x = frozen_return(model, trial, phi, 50);
    return phi - phi_n - rate.v * x[1] - rate.w * x[2];
  };
  double a = phi_n, gap_a = gap(a);
  if (!std::isfinite(gap_a)) return false;
  const double direction = gap_a > 0 ? -1 : 1;
  double step = std::abs(gap_a) / 4 + 1e-14, b = a, gap_b = gap_a;
  // The state nearest to the old one: the first change of sign met on the way. It may be far from a trial
  // that is hardly outside, where dilation softens faster than the elastic stress falls.
  for (; step < 1 && gap_b * gap_a > 0; step *= 1.3) {
    a = b;
    b += direction * step;
    gap_b = gap(b);
    if (!std::isfinite(gap_b)) return false;
  }
  if (gap_b * gap_a > 0) return false;
  for (int i = 0; i < 50; ++i) {
    const double c = (a + b) / 2, gap_c = gap(c);
    (gap_c * gap_b > 0 ? b : a) = c;
  }
  gap((a + b) / 2);
  return true;
}

/// The determinant `det` of the return over that with moduli and surface frozen. In isotropic compression it
/// is 1 + (|p|/K)(d(ln sigma_y)/d(phi) - d(ln K)/d(phi)), but for the elastic volume change. Where it is not
/// positive, a further compaction by plastic flow would raise the elastic pressure faster than the strength:
/// the root is no state that a compression leads to.
template <class T>
T densification_margin(const ReturnOf<T>& e, const T& det, const TrialInvariantsOf<T>& trial, const T& unit) {
  const auto& [K, G, K_phi, G_phi] = e.moduli;
  const auto& f = e.at;
  const T dv = trial.eps_v - e.eps_v, dw = trial.eps_q - e.eps_q;
  // The Jacobian with K_phi, G_phi and what the surface changes with phi left out; it has a zero at its end.
  const T p_s = f.p_s * unit, q_s = f.q_s * unit, p_v = K * (1 - e.eps_v) * e.exp_v * unit,
          q_v = 3 * G * e.eps_q * e.exp_v * unit, q_w = 3 * G * e.exp_v * unit;
  const T frozen =
      -p_s * (q_w * f.n_q - q_v * f.n_p) + p_v * (q_s * f.n_p + q_w * (f.n_q_s * dv - f.n_p_s * dw));
  return det / frozen;
}

/// The same at the beginning of plastic flow, on the surface at phi_n near the place s.
template <InvariantModel M>
[[gnu::noinline]] double densification_margin(const M& model, double phi_n, double s, double unit) {
  const auto [m, surface] = properties(model, phi_n);
  const double at = std::min(std::max(s, surface.s_min()), surface.s_max());
  const SurfacePoint f = surface.at(at);
  const double eps_v = volumetric_strain(f.p, m.K);
  const Trial yielding{{eps_v, f.q / (3 * m.G) * std::exp(eps_v)}, std::exp(-eps_v)};
  const Return e = evaluate_return(model, yielding, phi_n, unit, {at, 0, 0});
  return densification_margin(e, Inverse3(e.J).det, yielding, unit);
}

/// The curve goes on, mirrored, behind its ends on the axis q = 0: pass an end by a tenth of its distance,
/// enough to converge on it, too little to find roots behind it.
inline constexpr double past_end = 1.1;

/// Newton with line search from x, to a residual of `rounding`: whether it found a root that is admissible.
template <InvariantModel M>
bool solve_return(const M& model, const Trial& trial, double phi_n, double unit, double rounding,
                  std::array<double, 3> x, Return& e) {
  const double tolerance = rounding * rounding, floor = 1e4 * tolerance;
  std::array<double, 3> dx{};
  double fraction = 0, before = std::numeric_limits<double>::infinity();
  for (int steps = 0, cuts = 0;;) {
    const std::array at{x[0] + fraction * dx[0], x[1] + fraction * dx[1], x[2] + fraction * dx[2]};
    e = evaluate_return(model, trial, phi_n, unit, at);
    const double merit = e.merit();
    if (!(merit < before * (1 - 1e-4 * fraction))) {
      if (++cuts < 8) {
        fraction /= 2;
        continue;
      }
      if (before <= floor) break; // at the floor of rounding
      return false;
    }
    if (merit <= tolerance) break;
    if (steps == 25) {
      if (merit <= floor) break;
      return false;
    }
    ++steps, cuts = 0;
    x = at;
    before = merit;
    dx = Inverse3(e.J).solve({-e.r[0], -e.r[1], -e.r[2]});
    fraction = 1;
    if (x[0] + dx[0] < e.s_min) fraction = std::min(fraction, past_end * (e.s_min - x[0]) / dx[0]);
    if (x[0] + dx[0] > e.s_max) fraction = std::min(fraction, past_end * (e.s_max - x[0]) / dx[0]);
    if (!(fraction > 0)) return false;
  }
  // A root is admissible if the plastic strain points outward, but for a trial that is outside by rounding
  // alone, and if it lies on the curve proper. Behind an end it does where the end itself solves the
  // equations as well as a root at the floor of rounding does.
  const double dv = trial.eps_v - e.eps_v, dw = trial.eps_q - e.eps_q;
  if (!(e.at.n_p * dv + e.at.n_q * dw > -rounding)) return false;
  if (e.s >= e.s_min && e.s <= e.s_max) return true;
  const SurfacePoint end = model.surface(e.phi).at(e.s < e.s_min ? e.s_min : e.s_max);
  const double p_off = (e.at.p - end.p) * unit, q_off = (e.at.q - end.q) * unit,
               n_off = end.n_q * dv - end.n_p * dw;
  return p_off * p_off + q_off * q_off + n_off * n_off <= floor;
}

/// The model's first guess of a return, and one Newton step from it towards the closest point of the surface
/// at phi_n, along the elastic tangent at the trial.
template <class Surface, class T>
Triple<T> first_guess(const Surface& surface, const ModuliOf<T>& m, const TrialOf<T>& trial,
                      const InvariantResponseOf<T>& u) {
  using core::pick;
  const T per_p_v = 1 / u.p_v, per_q_q = 1 / u.q_q;
  T s = surface.first_guess(u.p, u.q, m);
  SurfacePointOf<T> f = surface.at(s);
  T dv = (u.p - f.p) * per_p_v;
  const T dw = (u.q - f.q) * per_q_q;
  const T gap = f.n_q * dv - f.n_p * dw;
  const T gap_s = f.n_q_s * dv - f.n_p_s * dw - f.n_q * f.p_s * per_p_v + f.n_p * f.q_s * per_q_q;
  const T closer = s - gap / gap_s;
  const auto taken = core::both(core::both(closer > surface.s_min(), closer < surface.s_max()), closer != s);
  if (core::any(taken)) {
    s = pick(taken, closer, s);
    f = surface.at(s);
    dv = (u.p - f.p) * per_p_v;
  }
  return {s, dv, trial.eps_q - (1 - dv) * f.q * per_q_q};
}

/// Stress, strain and tangent at the root e; `inverse` of its Jacobian.
template <InvariantModel M, class T>
void take(const ReturnOf<T>& e, const Inverse3Of<T>& inverse, const T& unit, InvariantResponseOf<T>& u) {
  constexpr PhiRate rate = M::phi_rate;
  u.p = e.at.p;
  u.q = e.at.q;
  u.eps_v = e.eps_v;
  u.eps_q = e.eps_q;
  u.exp_v = e.exp_v;
  u.phi = e.phi;
  // d(s, dv, dw) = -J^-1 dr, then the stress along the surface.
  const auto by_v = inverse.solve({-e.moduli.K * (1 - e.eps_v) * e.exp_v * unit, u.q * unit, T{}});
  const auto by_q = inverse.solve({T{}, -3 * e.moduli.G * e.exp_v * unit, T{}});
  const auto along = [&](const Triple<T>& d, const T& by_s, const T& by_phi) -> T {
    return by_s * d[0] + by_phi * (rate.v * d[1] + rate.w * d[2]);
  };
  u.p_v = along(by_v, e.at.p_s, e.at.p_phi);
  u.q_v = along(by_v, e.at.q_s, e.at.q_phi);
  u.p_q = along(by_q, e.at.p_s, e.at.p_phi);
  u.q_q = along(by_q, e.at.q_s, e.at.q_phi);
}

} // namespace detail

/// Elastic response of a trial strain; exp_v = e^{-eps_v}.
template <class T>
InvariantResponseOf<T> elastic_response(const ModuliOf<T>& m, const TrialInvariantsOf<T>& trial,
                                        const T& exp_v, const T& phi) {
  InvariantResponseOf<T> u;
  u.eps_v = trial.eps_v;
  u.eps_q = trial.eps_q;
  u.exp_v = exp_v;
  u.phi = phi;
  u.p = m.K * trial.eps_v * exp_v;
  u.q = 3 * m.G * trial.eps_q * exp_v;
  u.p_v = m.K * (1 - trial.eps_v) * exp_v;
  u.q_v = -u.q;
  u.q_q = 3 * m.G * exp_v;
  return u;
}

/// Backward Euler update of one material point: `u` is its elastic response, outside the surface at phi_n,
/// and becomes its state, but for the status, which is returned; a refusal leaves the rest unspecified.
/// Flattened: what the surfaces and moduli return stays in registers, and what is not needed of it is not
/// computed.
template <InvariantModel M, class Surface>
[[nodiscard, gnu::flatten, gnu::noinline]] Status integrate(const M& model, const Moduli& m_n,
                                                            const Surface& surface_n, InvariantResponse& u) {
  const double phi_n = u.phi;
  const detail::Trial trial{{u.eps_v, u.eps_q}, u.exp_v};
  if (!std::isfinite(u.p) || !std::isfinite(u.q)) return Status::refused;

  const auto guess = detail::first_guess(surface_n, m_n, trial, u);
  const double s_n = guess[0], unit = 1 / (3 * m_n.G);
  const double rounding = relative_return_tolerance * (std::abs(trial.eps_v) + trial.eps_q);
  // Where the first densification outruns the surface there is no root nearby; one far away is no state that
  // this strain leads to.
  const auto outrun = [&] {
    return surface_n.zone(s_n) == Zone::compaction &&
           detail::densification_margin(model, phi_n, s_n, unit) <= 0;
  };
  detail::Return e;
  Status status = Status::plastic;
  detail::Triple<double> start = guess;
  for (int attempt = 0; !detail::solve_return(model, trial, phi_n, unit, rounding, start, e); ++attempt) {
    if (attempt == 0) start = detail::frozen_return(model, trial, phi_n, 30);
    else if (attempt == 2) return Status::refused;
    else {
      status = Status::bracketed;
      if (outrun()) return Status::unstable;
      if (!detail::bracketed_start(model, trial, phi_n, start)) return Status::refused;
    }
  }
  if (e.zone == Zone::compaction && std::abs(trial.eps_v - e.eps_v) > 2 * std::abs(guess[1]) && outrun())
    return Status::unstable;

  const detail::Inverse3 inverse(e.J);
  if (!(std::abs(inverse.det) > 0)) return Status::refused;
  if (e.zone == Zone::compaction && detail::densification_margin<double>(e, inverse.det, trial, unit) <= 0)
    return Status::unstable;
  detail::take<M>(e, inverse, unit, u);
  u.zone = e.zone;
  return status;
}

} // namespace platen::material
