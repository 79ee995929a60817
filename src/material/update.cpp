#include "material/update.hpp"

#include "core/float_traps.hpp"
#include "core/vector_clones.hpp"
#include "material/lane_return.hpp"

#include <cassert>
#include <cmath>
#include <type_traits>

namespace platen::material {
namespace {

/// The same fields of one point or of eight.
template <class T> struct PrincipalOf {
  std::array<T, 3> sigma, eps;
  std::array<std::array<T, 3>, 3> D;
};

/// Principal stresses and their tangent from the invariant response: sigma_A = p + q m_A, m_A = 2 e_A/(3
/// eps_q).
template <class T, class Out>
void to_principal(const std::array<T, 3>& eps_trial, const TrialInvariantsOf<T>& trial,
                  const InvariantResponseOf<T>& u, Out& out) {
  using core::pick;
  const T mean = trial.eps_v / 3;
  std::array<T, 3> m{};
  // Without a deviator the limit of q/eps_q.
  const auto turned = trial.eps_q > 1e-14;
  const T per_eps_q = pick(turned, 1 / trial.eps_q, T{});
  const T spin = 2.0 / 3 * pick(turned, u.q * per_eps_q, u.q_q);
  for (int A = 0; A < 3; ++A) m[A] = 2.0 / 3 * (eps_trial[A] - mean) * per_eps_q;
  // D = (p_v + p_q m_B) + m_A (q_v + q_q m_B) + spin (delta_AB - 1/3 - 3/2 m_A m_B)
  const T constant = u.p_v - spin / 3, product = u.q_q - 1.5 * spin;
  for (int A = 0; A < 3; ++A) {
    out.sigma[A] = u.p + u.q * m[A];
    out.eps[A] = u.eps_v / 3 + 1.5 * u.eps_q * m[A];
    for (int B = 0; B < 3; ++B) out.D[A][B] = constant + u.p_q * m[B] + m[A] * (u.q_v + product * m[B]);
    out.D[A][A] += spin;
  }
}

void finish(const std::array<double, 3>& eps_trial, TrialInvariants trial, const InvariantResponse& u,
            PointUpdate& out) {
  to_principal(eps_trial, trial, u, out);
  out.p = u.p;
  out.q = u.q;
  out.phi = u.phi;
  out.dv = trial.eps_v - u.eps_v;
  out.dw = trial.eps_q - u.eps_q;
  out.plastic_work = (u.p * out.dv + u.q * out.dw) / u.exp_v;
  out.status = u.status;
  out.zone = u.zone;
}

/// A return in principal stresses need not keep the direction of the deviator: dw is then what the stress
/// works on, 3G eps_q dw = 2G e : d(e^p).
void finish(const std::array<double, 3>& eps_trial, TrialInvariants trial, double phi_n,
            const PrincipalResponse& u, PointUpdate& out) {
  const TrialInvariants elastic = invariants(u.eps);
  out.sigma = u.sigma;
  out.eps = u.eps;
  out.D = u.D;
  out.p = (u.sigma[0] + u.sigma[1] + u.sigma[2]) / 3;
  out.q = 1.5 * invariants(u.sigma).eps_q; // sqrt(3/2 s:s)
  out.dv = trial.eps_v - elastic.eps_v;
  double e_de = 0, work = 0;
  for (int A = 0; A < 3; ++A) {
    e_de += (u.eps[A] - elastic.eps_v / 3) * (eps_trial[A] - u.eps[A]);
    work += u.sigma[A] * (eps_trial[A] - u.eps[A]);
  }
  out.dw = elastic.eps_q > 0 ? 2.0 / 3 * e_de / elastic.eps_q : 0;
  out.phi = phi_n - out.dv;
  out.plastic_work = std::exp(elastic.eps_v) * work;
  out.status = u.status;
  out.zone = u.zone;
}

/// sigma_A = (lambda eps_v + 2G eps_A) e^{-eps_v}, and its derivatives.
void finish_elastic(const std::array<double, 3>& eps, TrialInvariants trial, double exp_v, const Moduli& m,
                    double phi, PointUpdate& out) {
  const double two_G = 2 * m.G * exp_v, lambda = m.K * exp_v - two_G / 3;
  for (int A = 0; A < 3; ++A) {
    out.sigma[A] = lambda * trial.eps_v + two_G * eps[A];
    for (int B = 0; B < 3; ++B) out.D[A][B] = lambda - out.sigma[A];
    out.D[A][A] += two_G;
  }
  out.eps = eps;
  out.p = m.K * trial.eps_v * exp_v;
  out.q = 3 * m.G * trial.eps_q * exp_v;
  out.phi = phi;
  out.plastic_work = out.dv = out.dw = 0;
  out.status = Status::elastic;
  out.zone = Zone::elastic;
}

template <class M>
void update_point(const M& model, const std::array<double, 3>& eps_trial, double phi_n, PointUpdate& out) {
  const TrialInvariants trial = invariants(eps_trial);
  if constexpr (PrincipalModel<M>)
    if (!in_invariants(model)) return finish(eps_trial, trial, phi_n, model.respond(eps_trial), out);
  const double exp_v = std::exp(-trial.eps_v);
  if constexpr (InvariantModel<M>) {
    const auto [moduli, surface] = properties(model, phi_n);
    const double p = moduli.K * trial.eps_v * exp_v, q = 3 * moduli.G * trial.eps_q * exp_v;
    if (!surface.contains(p, q)) {
      InvariantResponse u = elastic_response(moduli, trial, exp_v, phi_n);
      u.status = integrate(model, moduli, surface, u);
      return finish(eps_trial, trial, u, out);
    }
    finish_elastic(eps_trial, trial, exp_v, moduli, phi_n, out);
  } else finish_elastic(eps_trial, trial, exp_v, model.moduli(phi_n), phi_n, out);
}

/// A model whose moduli, and where it does not harden its surface, are computed once.
template <InvariantModel M> struct Prepared {
  const M& model;
  Moduli fixed_moduli;
  decltype(model.surface(0)) fixed_surface = model.surface(0);
  static constexpr PhiRate phi_rate = M::phi_rate;

  Moduli moduli(double) const { return fixed_moduli; }
  auto surface(double phi) const {
    if constexpr (requires { requires M::perfectly_plastic; }) return fixed_surface;
    else return model.surface(phi);
  }
};

/// Eight points side by side; those that it does not find go point by point.
template <LaneModel M>
void update_lanes(const M& model, const std::array<double, 3>* eps_trial, const double* phi_n,
                  PointUpdate* out) {
  using T = core::Lanes;
  constexpr int lanes = core::lanes<T>;
  std::array<T, 3> eps;
  T phi;
  for (int i = 0; i < lanes; ++i) {
    for (int A = 0; A < 3; ++A) eps[A][i] = eps_trial[i][A];
    phi[i] = phi_n[i];
  }
  const T eps_v = eps[0] + eps[1] + eps[2];
  T squares{};
  for (const T& e : eps) squares += (e - eps_v / 3) * (e - eps_v / 3);
  const TrialInvariantsOf<T> trial{eps_v, core::sqrt(2.0 / 3 * squares)};
  const auto [moduli, surface] = properties(model, phi);
  auto u = elastic_response<T>(moduli, trial, core::exp(-eps_v), phi);
  const core::Mask<core::Lanes> outside = ~surface.contains(u.p, u.q);
  core::Mask<core::Lanes> left = outside;
  T zone = T{} + static_cast<double>(Zone::elastic);
  if (core::any(outside)) left &= ~integrate(model, moduli, surface, outside, u, zone);

  PrincipalOf<T> principal;
  to_principal(eps, trial, u, principal);
  const T dv = eps_v - u.eps_v, dw = trial.eps_q - u.eps_q, work = (u.p * dv + u.q * dw) / u.exp_v;
  for (int i = 0; i < lanes; ++i) {
    PointUpdate& o = out[i];
    for (int A = 0; A < 3; ++A) {
      o.sigma[A] = principal.sigma[A][i];
      o.eps[A] = principal.eps[A][i];
      for (int B = 0; B < 3; ++B) o.D[A][B] = principal.D[A][B][i];
    }
    o.p = u.p[i], o.q = u.q[i], o.phi = u.phi[i];
    o.dv = dv[i], o.dw = dw[i], o.plastic_work = work[i];
    o.zone = static_cast<Zone>(static_cast<int>(zone[i]));
    o.status = outside[i] ? Status::plastic : Status::elastic;
  }
  for (int i = 0; i < lanes; ++i)
    if (left[i]) update_point(model, eps_trial[i], phi_n[i], out[i]);
}

#ifndef PLATEN_PLAIN
PLATEN_VECTOR_CLONES [[gnu::flatten]] void update_eight(const Vmdc& model,
                                                        const std::array<double, 3>* eps_trial,
                                                        const double* phi_n, PointUpdate* out) {
  update_lanes(model, eps_trial, phi_n, out);
}
#endif

template <class M>
UpdateCounts update_all(const M& model, std::span<const std::array<double, 3>> eps_trial,
                        std::span<const double> phi_n, std::span<PointUpdate> out) {
  UpdateCounts counts;
  std::size_t done = 0;
#ifndef PLATEN_PLAIN
  if constexpr (LaneModel<M>)
    for (constexpr int lanes = core::lanes<core::Lanes>; done + lanes <= out.size(); done += lanes)
      update_eight(model, &eps_trial[done], &phi_n[done], &out[done]);
#endif
  for (std::size_t i = done; i < out.size(); ++i) update_point(model, eps_trial[i], phi_n[i], out[i]);
  for (const PointUpdate& point : out) {
    const Status status = point.status;
    counts.plastic += status == Status::plastic || status == Status::bracketed;
    counts.bracketed += status == Status::bracketed;
    counts.refused += is_refused(status);
    counts.unstable += status == Status::unstable;
  }
  return counts;
}

} // namespace

TrialInvariants invariants(const std::array<double, 3>& eps) {
  const double v = eps[0] + eps[1] + eps[2];
  const double a = eps[0] - v / 3, b = eps[1] - v / 3, c = eps[2] - v / 3;
  return {v, std::sqrt(2.0 / 3 * (a * a + b * b + c * c))};
}

UpdateCounts update(const Model& model, std::span<const std::array<double, 3>> eps_trial,
                    std::span<const double> phi_n, std::span<PointUpdate> out) {
  assert(eps_trial.size() == phi_n.size() && phi_n.size() == out.size());
  const core::NoFloatTraps of_lanes;
  return std::visit(
      [&]<class M>(const M& m) {
        if constexpr (requires { requires M::fixed_moduli; })
          if (in_invariants(m)) return update_all(Prepared<M>{m, m.moduli(0)}, eps_trial, phi_n, out);
        return update_all(m, eps_trial, phi_n, out);
      },
      model);
}

PointUpdate update_with_old_moduli(const Model& model, const std::array<double, 3>& eps_trial, double phi_n) {
  PointUpdate out{};
  std::visit(
      [&]<class M>(const M& m) {
        if constexpr (InvariantModel<M>)
          if (in_invariants(m)) {
            const Moduli old = m.moduli(phi_n);
            return update_point(Prepared<M>{m, {old.K, old.G}}, eps_trial, phi_n, out);
          }
        update_point(m, eps_trial, phi_n, out);
      },
      model);
  return out;
}

double stored_energy(const Model& model, TrialInvariants elastic, double phi) {
  const Moduli m = std::visit([&](const auto& x) { return x.moduli(phi); }, model);
  return (m.K * elastic.eps_v * elastic.eps_v + 3 * m.G * elastic.eps_q * elastic.eps_q) / 2;
}

double plastic_volume_ratio(const Model& model, double phi) {
  return std::visit(
      [phi]<class M>(const M&) {
        if constexpr (requires { requires M::phi_rate.v == -1 && M::phi_rate.w == 0; }) return std::exp(-phi);
        else return 1.0;
      },
      model);
}

double relative_density(const Model& model, double phi) {
  return std::visit(
      [phi](const auto& m) {
        if constexpr (requires { m.rho_r(phi); }) return m.rho_r(phi);
        else return 1.0;
      },
      model);
}

Bounds active_bounds(const Model& model, double phi) {
  return std::visit(
      [phi](const auto& m) {
        if constexpr (requires { m.bounds(phi); }) return m.bounds(phi);
        else return Bounds{};
      },
      model);
}

} // namespace platen::material
