#pragma once
// The return of the integrator (material/integrator.hpp) for eight points side by side, by plain Newton
// steps.

#include "material/integrator.hpp"

namespace platen::material {

/// Backward Euler update of eight points: the elastic responses u of those `outside` become their states,
/// `zone` the numbers of their zones. Returns which did; the others, where a single point looks
/// further or refuses, stay elastic.
template <LaneModel M, class Surface>
core::Mask<core::Lanes> integrate(const M& model, const ModuliOf<core::Lanes>& m_n, const Surface& surface_n,
                                  const core::Mask<core::Lanes>& outside, InvariantResponseOf<core::Lanes>& u,
                                  core::Lanes& zone) {
  using core::abs, core::pick;
  using T = core::Lanes;
  const T phi_n = u.phi, unit = 1 / (3 * m_n.G);
  const detail::TrialOf<T> trial{{u.eps_v, u.eps_q}, u.exp_v};
  const auto guess = detail::first_guess(surface_n, m_n, trial, u);
  const T rounding = relative_return_tolerance * (abs(trial.eps_v) + trial.eps_q);
  const T tolerance = rounding * rounding;
  auto x = guess;
  T before = T{} + std::numeric_limits<double>::infinity(), fraction{};
  detail::ReturnOf<T> e;
  core::Mask<core::Lanes> under_way = outside, found{};
  for (int steps = 0; steps < 12; ++steps) {
    e = detail::evaluate_return(model, trial, phi_n, unit, x);
    const T merit = e.merit();
    found |= under_way & (merit <= tolerance);
    under_way &= ~found & (merit < before * (1 - 1e-4 * fraction));
    if (!core::any(under_way)) break;
    before = merit;
    const auto dx = detail::Inverse3Of<T>(e.J).solve({-e.r[0], -e.r[1], -e.r[2]});
    const T reached = x[0] + dx[0];
    const T end = pick(reached < e.s_min, e.s_min, pick(reached > e.s_max, e.s_max, reached));
    const T past = detail::past_end * (end - x[0]) / dx[0], whole = T{} + 1;
    fraction = pick(core::both(end != reached, past < 1), past, whole);
    under_way &= fraction > 0;
    for (int i = 0; i < 3; ++i) x[i] = pick(under_way, x[i] + fraction * dx[i], x[i]);
  }
  const T dv = trial.eps_v - e.eps_v, dw = trial.eps_q - e.eps_q;
  found &= (e.at.n_p * dv + e.at.n_q * dw > -rounding) & (e.s >= e.s_min) & (e.s <= e.s_max);
  const detail::Inverse3Of<T> inverse(e.J);
  const auto compacts = e.zone == static_cast<double>(Zone::compaction);
  found &= abs(inverse.det) > 0;
  found &= ~compacts | ((abs(dv) <= 2 * abs(guess[1])) &
                        (detail::densification_margin<T>(e, inverse.det, trial, unit) > 0));
  InvariantResponseOf<T> plastic;
  detail::take<M>(e, inverse, unit, plastic);
  using U = InvariantResponseOf<T>;
  const auto become = [&](auto... of) { ((u.*of = pick(found, plastic.*of, u.*of)), ...); };
  become(&U::p, &U::q, &U::eps_v, &U::eps_q, &U::exp_v, &U::phi, &U::p_v, &U::p_q, &U::q_v, &U::q_q);
  zone = pick(found, e.zone, T{} + static_cast<double>(Zone::elastic));
  return found;
}

} // namespace platen::material
