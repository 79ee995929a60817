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
// A contact remembers nothing but its last and its largest overlap: the unloading curve follows from the
// largest one. It is found anew at each call, from small tables: cheaper than reading it back from memory.
//
// Adhesion is in none of the papers. An adhesive law would return negative forces from `loading` and
// `unloading`; nothing here assumes more than F(0) = 0 at first contact.

#include "platen/law/fast_power.hpp"
#include "platen/law/macros.hpp"

#include <cmath>
#include <concepts>
#include <numbers>

namespace platen::law {

enum class Branch : unsigned char { separated, loading, unloading, reloading };

/// How the force falls below the largest overlap.
enum class Shape : unsigned char {
  power,     ///< F_max xi^alpha
  indenter,  ///< of an elliptic indenter in springs (mdr.hpp)
  difference ///< F_max (u^n - lambda_p)/(1 - lambda_p), u = gamma/gamma_max (eepa.hpp)
};

/// What one contact remembers. Zero at first touch; both sides share it, so swapping them changes nothing.
template <class Real = double> struct BasicState {
  Real gamma{};     ///< last overlap [m]; tells unloading from reloading
  Real gamma_max{}; ///< largest overlap so far [m]
};

/// What the memory of a contact is called, in its order, and the version of that order.
inline constexpr const char* state_names[] = {"gamma [m]", "gamma_max [m]"};
inline constexpr unsigned state_version = 1;

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
  Real F{};        ///< [N]
  Real slope{};    ///< dF/dgamma [N/m]
  Real a{};        ///< contact radius [m]
  Real steepest{}; ///< largest d ln F/d ln gamma from 0 to here; for unloading
  Real least_a{};  ///< lower bound of d ln S/d ln gamma from 0 to here, S the unloading slope; for unloading
};

/// F = F_max xi^alpha, xi = 1 - rate (gamma_max - gamma); the force ends at gamma_0 = gamma_max - 1/rate.
template <class Real = double> struct Unloading {
  Real rate{};  ///< [1/m]
  Real alpha{}; ///< [-]

  [[nodiscard]] PLATEN_FUNCTION Real gamma_0(const Real& gamma_max) const {
    return gamma_max - Real(1) / rate;
  }
};

/// What is kept of the loading curve and of the unloading that leaves it at the largest overlap.
template <class Real = double> struct Peak {
  Real F{};            ///< [N]
  Real slope{};        ///< of the loading curve [N/m]
  Real a{};            ///< contact radius [m]
  Unloading<Real> end; ///< of the contact
  Real work{};         ///< of loading [J]
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

/// A law whose unloading is no power law gives force, slope and radius below gamma_max itself. `unloading`
/// then says where that curve ends, and the exponent with which a power law would return the same work.
template <class Law>
concept OwnUnloading = ContactLaw<Law> &&
    requires(const Law law, typename Law::Scalar gamma, Peak<typename Law::Scalar> peak) {
  { law.on_unloading(gamma, gamma, peak) } -> std::same_as<Loading<typename Law::Scalar>>;
};

template <class Real> PLATEN_FUNCTION Real larger(const Real& a, const Real& b) { return a < b ? b : a; }

template <class Real> PLATEN_FUNCTION Real smaller(const Real& a, const Real& b) { return b < a ? b : a; }

/// The power-law unloading curve that leaves (gamma_max, F_max) with slope S and exponent alpha, made stiffer
/// where it would create energy. With beta = S gamma_max/F_max, n the steepest d ln F/d ln gamma of the
/// loading curve so far and s a lower bound of d ln S/d ln gamma_max:
/// - below the loading curve: beta >= n, since (1 - t beta/alpha)^alpha <= (1 - t)^beta (Bernoulli);
/// - the work that comes back grows by less than F_max d gamma_max:
///     residual overlap (beta > alpha):  beta >= alpha (2n - s)/(1 + alpha)
///     bent to end at the origin:        beta (beta + 2 + s) >= n (1 + 2 beta)
/// Hertz (n = 3/2, s = 1/2) meets both with equality at beta = alpha = 3/2, and unloads along itself.
/// Given as S_gamma = S gamma_max [N], because that is what tables hold.
template <class Real>
PLATEN_HOT Unloading<Real> unloading_from_slope(const Real& gamma_max, const Loading<Real>& peak,
                                                const Real& S_gamma, const Real& alpha) {
  using std::sqrt;
  const Real n = peak.steepest, s = peak.least_a;
  Real beta_F = S_gamma; // beta F_max
  if (n <= Real(1) + s && n <= alpha) {
    beta_F = larger(beta_F, n * peak.F);      // the second and third follow from the first
  } else if (beta_F < Real(2) * n * peak.F) { // else it is stiff enough for all three
    const Real half = n - Real(1) - s / Real(2);
    beta_F = larger(beta_F, peak.F * larger(n, half + sqrt(half * half + n)));
    if (alpha * peak.F < beta_F)
      beta_F = larger(beta_F, peak.F * alpha * (Real(2) * n - s) / (Real(1) + alpha));
  }
  if (!(alpha * peak.F < beta_F)) return {Real(1) / gamma_max, beta_F / peak.F};
  return {beta_F / (alpha * peak.F * gamma_max), alpha};
}

template <class Real> PLATEN_HOT Real power(const Real& base, const Real& exponent) {
  using std::pow, std::sqrt;
  if (exponent == Real(0.5)) return sqrt(base); // the generic unloading; several times faster
  if (base == Real(1)) return Real(1);          // on the loading curve
  if constexpr (std::same_as<Real, double>) return detail::fast_power(base, exponent);
  else return pow(base, exponent);
}

namespace detail {

template <class Real> PLATEN_FUNCTION Real mean_pressure(const Real& F, const Real& a) {
  return a > Real(0) ? F / (Real(std::numbers::pi) * a * a) : Real(0);
}

/// Work that unloading from gamma_max does not return.
template <class Real> PLATEN_HOT Real dissipated_work(const Real& gamma_max, const Peak<Real>& peak) {
  const auto& [rate, alpha] = peak.end;
  Real back = peak.F / (rate * (Real(1) + alpha));
  const Real xi = Real(1) - rate * gamma_max;
  if (Real(1e-9) < xi) // only some published curves, which still carry force when the bodies part
    back = back * (Real(1) - xi * power(xi, alpha));
  return peak.work - back;
}

} // namespace detail

/// From the formulas of the law.
template <ContactLaw Law, class Real = typename Law::Scalar>
PLATEN_HOT Peak<Real> formula_peak(const Law& law, const Real& gamma) {
  const Loading<Real> l = law.loading(gamma);
  if (!(Real(0) < l.F)) return {}; // an overlap so small that its force is no number
  return {l.F, l.slope, l.a, law.unloading(gamma, l), law.work(gamma)};
}

/// The whole law in one pure step: remembered state and overlap in, response and new state out. On the
/// loading curve the unloading formula returns F_max itself, so loading and unloading share one path without
/// a branch.
template <ContactLaw Law, class Real = typename Law::Scalar>
PLATEN_HOT BasicResponse<Real> evaluate(const Law& law, const BasicState<Real>& old, const Real& overlap) {
  BasicResponse<Real> now;
  if (overlap != overlap) { // no number: no answer, and the memory stays
    now.force = now.stiffness = now.contact_radius = now.mean_pressure = now.dissipated_work = overlap;
    now.state = old;
    now.in_range = false;
    return now;
  }
  const bool beyond = law.gamma_limit < overlap;
  const Real gamma = beyond ? Real(law.gamma_limit) : overlap;
  const Real gamma_max = larger(gamma, old.gamma_max);
  now.state = {gamma, gamma_max};
  now.in_range = !(Real(0) < gamma_max) || (!beyond && law.in_range(gamma_max));

  const bool elastic = gamma_max <= law.gamma_elastic;
  const Real top = elastic ? gamma : gamma_max; // where the loading curve is left
  if (!(Real(0) < top)) return now;             // never touched, or apart without a trace
  const Peak<Real> peak = formula_peak(law, top);
  if (!(Real(0) < peak.F)) return now;
  const Unloading<Real>& end = peak.end;
  now.dissipated_work = elastic ? Real(0) : detail::dissipated_work(top, peak);
  const Real xi = Real(1) - end.rate * (top - gamma);
  if (!(Real(0) < xi && Real(0) < gamma)) return now; // separated

  if constexpr (OwnUnloading<Law>) {
    const Loading<Real> at =
        gamma < top ? law.on_unloading(gamma, top, peak) : Loading<Real>{peak.F, peak.slope, peak.a};
    now.force = at.F;
    now.stiffness = beyond ? Real(0) : at.slope;
    now.contact_radius = at.a;
  } else {
    const Real shrink = power(xi, end.alpha - Real(1));
    now.force = peak.F * xi * shrink;
    now.stiffness = beyond ? Real(0) : gamma < top ? peak.F * end.alpha * shrink * end.rate : peak.slope;
    now.contact_radius = peak.a * shrink; // dF/dgamma stays proportional to a, as for any elastic punch
  }
  now.mean_pressure = detail::mean_pressure(now.force, now.contact_radius);
  now.branch = old.gamma_max < gamma ? Branch::loading
               : gamma < old.gamma   ? Branch::unloading
                                     : Branch::reloading;
  return now;
}

} // namespace platen::law
