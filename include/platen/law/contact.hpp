#pragma once
// What every contact law says to its host, and the one procedure that all laws share: follow the loading
// curve to a new maximum, unload and reload below it.
//
// gamma is the approach of the two centres [m] (against a plane: of the centre to the plane), compression and
// force are positive. A law is a small prepared object; it knows its loading curve and how it unloads:
//
//   law.loading(gamma)   force, slope, contact radius on the loading curve
//   law.in_range(gamma)  was the law made for this overlap (and material)?
//   law.work(gamma)      integral of that force from 0 to gamma [J]
//   law.unloading(gamma_max, loading at gamma_max)   where and how the unloading curve ends
//   law.gamma_elastic    up to this overlap unloading retraces the loading curve (0: no elastic range)
//   law.gamma_limit      overlap beyond which everything is held constant (far outside any validity)
//
// Adhesion is in none of the papers. An adhesive law would return negative forces from `loading` and
// `unloading`; nothing here assumes more than F(0) = 0 at first contact.

#include "platen/law/macros.hpp"

#include <cmath>
#include <concepts>
#include <numbers>

namespace platen::law {

enum class Branch : unsigned char { separated, loading, unloading, reloading };

/// What one contact remembers. Zero-initialised at first touch; both sides share it, so swapping them is
/// free.
template <class Real = double> struct BasicState {
  Real gamma{};     ///< last overlap [m]; tells unloading from reloading
  Real gamma_max{}; ///< largest overlap so far [m]
  Real gamma_0{};   ///< overlap at which the force returns to zero [m]   } found when unloading starts,
  Real F_max{};     ///< force at gamma_max [N]                           } then kept
  Real a_max{};     ///< contact radius at gamma_max [m]                  }
  Real alpha{};     ///< exponent of the unloading curve; 0 while it is not known
};

template <class Real = double> struct BasicResponse {
  Real force{};           ///< [N]
  Real stiffness{};       ///< dF/dgamma [N/m], analytic
  Real contact_radius{};  ///< of the circle with the area of the contact [m]
  Real mean_pressure{};   ///< F/(pi a^2) [Pa]
  Real dissipated_work{}; ///< work that unloading from the largest overlap so far does not return [J]
  BasicState<Real> state; ///< to be given to the next call
  Branch branch = Branch::separated;
  bool in_range = true; ///< false: outside what the law was made for; the values continue monotonically
};

using State = BasicState<double>;
using Response = BasicResponse<double>;

/// A point of a loading curve.
template <class Real = double> struct Loading {
  Real F{};     ///< [N]
  Real slope{}; ///< dF/dgamma [N/m]
  Real a{};     ///< contact radius [m]
};

/// F = F_max ((gamma - gamma_0) / (gamma_max - gamma_0))^alpha
template <class Real = double> struct Unloading {
  Real gamma_0{};
  Real alpha{};
};

template <class Law>
concept ContactLaw = requires(const Law law, typename Law::Scalar gamma, Loading<typename Law::Scalar> peak) {
  { law.loading(gamma) } -> std::same_as<Loading<typename Law::Scalar>>;
  { law.in_range(gamma) } -> std::same_as<bool>;
  { law.work(gamma) } -> std::same_as<typename Law::Scalar>;
  { law.unloading(gamma, peak) } -> std::same_as<Unloading<typename Law::Scalar>>;
  { law.gamma_elastic } -> std::convertible_to<typename Law::Scalar>;
  { law.gamma_limit } -> std::convertible_to<typename Law::Scalar>;
};

template <class Real> PLATEN_FUNCTION Real larger(const Real& a, const Real& b) { return a < b ? b : a; }

template <class Real> PLATEN_FUNCTION Real smaller(const Real& a, const Real& b) { return b < a ? b : a; }

/// The power-law unloading curve that leaves (gamma_max, F_max) with slope S and exponent alpha, made stiffer
/// where it would create energy. With n the steepest d ln F/d ln gamma of the loading curve so far, s a lower
/// bound of d ln S/d ln gamma_max, and beta = S gamma_max/F_max:
/// - below the loading curve: beta >= n, since (1 - t beta/alpha)^alpha <= (1 - t)^beta (Bernoulli);
/// - the work that comes back grows by less than F_max d gamma_max:
///     residual overlap (beta > alpha):  beta >= alpha (2n - s)/(1 + alpha)
///     bent to end at the origin:        beta (beta + 2 + s) >= n (1 + 2 beta)
/// Hertz (n = 3/2, s = 1/2) meets both with equality at beta = alpha = 3/2, and unloads along itself.
template <class Real>
PLATEN_FUNCTION Unloading<Real> unloading_from_slope(const Real& gamma_max, const Real& F_max, const Real& S,
                                                     const Real& alpha, const Real& n, const Real& s) {
  using std::sqrt;
  if (!(F_max > Real(0))) return {gamma_max, Real(1)};
  const Real half = n - Real(1) - s / Real(2);
  Real beta = larger(S * gamma_max / F_max, larger(n, half + sqrt(half * half + n)));
  if (beta <= alpha) return {Real(0), beta};
  beta = larger(beta, alpha * (Real(2) * n - s) / (Real(1) + alpha));
  return {gamma_max * (Real(1) - alpha / beta), alpha};
}

template <class Real> PLATEN_FUNCTION Real power(const Real& base, const Real& exponent) {
  using std::pow, std::sqrt;
  if (exponent == Real(0.5)) return sqrt(base); // the generic unloading; several times faster
  return pow(base, exponent);
}

namespace detail {

template <class Real> PLATEN_FUNCTION Real mean_pressure(const Real& F, const Real& a) {
  return a > Real(0) ? F / (Real(std::numbers::pi) * a * a) : Real(0);
}

template <class Law, class Real>
PLATEN_FUNCTION Real dissipated_work(const Law& law, const Real& gamma_max, const Real& F_max,
                                     const Unloading<Real>& end) {
  Real back = F_max * (gamma_max - end.gamma_0) / (Real(1) + end.alpha);
  if (end.gamma_0 < Real(0)) { // only some published curves, which still carry force when the bodies part
    const Real xi = end.gamma_0 / (end.gamma_0 - gamma_max);
    back = back * (Real(1) - xi * power(xi, end.alpha));
  }
  return law.work(gamma_max) - back;
}

} // namespace detail

/// The whole law in one pure step: remembered state and overlap in, response and new state out.
template <ContactLaw Law, class Real = typename Law::Scalar>
PLATEN_FUNCTION BasicResponse<Real> evaluate(const Law& law, const BasicState<Real>& old,
                                             const Real& overlap) {
  BasicResponse<Real> now;
  const bool beyond = law.gamma_limit < overlap;
  const Real gamma = beyond ? Real(law.gamma_limit) : overlap;
  now.state = old;
  now.state.gamma = gamma;
  now.in_range = !beyond && law.in_range(larger(gamma, old.gamma_max));

  const bool new_maximum = old.gamma_max < gamma;
  const bool elastic = old.gamma_max <= law.gamma_elastic;
  if (new_maximum || elastic) { // on the loading curve, up or down
    if (new_maximum) {
      now.state.gamma_max = gamma;
      now.state.alpha = Real(0);
    }
    if (!(gamma > Real(0))) return now;
    const Loading<Real> at = law.loading(gamma);
    now.force = at.F;
    now.stiffness = beyond ? Real(0) : at.slope;
    now.contact_radius = at.a;
    now.mean_pressure = detail::mean_pressure(at.F, at.a);
    now.branch = new_maximum ? Branch::loading : gamma < old.gamma ? Branch::unloading : Branch::reloading;
    if (law.gamma_elastic < gamma)
      now.dissipated_work = detail::dissipated_work(law, gamma, at.F, law.unloading(gamma, at));
    return now;
  }

  if (old.alpha == Real(0)) { // unloading starts: find its curve once
    const Loading<Real> peak = law.loading(old.gamma_max);
    const Unloading<Real> end = law.unloading(old.gamma_max, peak);
    now.state.F_max = peak.F;
    now.state.a_max = peak.a;
    now.state.gamma_0 = end.gamma_0;
    now.state.alpha = end.alpha;
  }
  const BasicState<Real>& s = now.state;
  now.dissipated_work = detail::dissipated_work(law, s.gamma_max, s.F_max, {s.gamma_0, s.alpha});
  if (gamma <= s.gamma_0 || !(gamma > Real(0))) return now;
  const Real xi = (gamma - s.gamma_0) / (s.gamma_max - s.gamma_0);
  const Real shrink = power(xi, s.alpha - Real(1));
  now.force = s.F_max * xi * shrink;
  now.stiffness = s.F_max * s.alpha * shrink / (s.gamma_max - s.gamma_0);
  now.contact_radius =
      s.a_max * shrink; // so that dF/dgamma stays proportional to a, as for any elastic punch
  now.mean_pressure = detail::mean_pressure(now.force, now.contact_radius);
  now.branch = gamma < old.gamma ? Branch::unloading : Branch::reloading;
  return now;
}

} // namespace platen::law
