#include "material/update.hpp"

#include <cassert>
#include <cmath>
#include <type_traits>

namespace platen::material {
namespace {

template <class M> InvariantResponse respond(const M& model, TrialInvariants trial, double phi_n) {
  if constexpr (PlasticModel<M>) return integrate(model, trial, phi_n);
  else return elastic_response(model.moduli(phi_n), trial, phi_n);
}

/// Principal stresses and their tangent from the invariant response: sigma_A = p + q m_A, m_A = 2 e_A/(3
/// eps_q).
void to_principal(const std::array<double, 3>& eps_trial, TrialInvariants trial, const InvariantResponse& u,
                  PointUpdate& out) {
  const double mean = trial.eps_v / 3;
  std::array<double, 3> m{};
  double spin = u.q_q; // limit of q/eps_q
  if (trial.eps_q > 1e-14) {
    for (int A = 0; A < 3; ++A) m[A] = (eps_trial[A] - mean) * 2 / (3 * trial.eps_q);
    spin = u.q / trial.eps_q;
  }
  for (int A = 0; A < 3; ++A) {
    out.sigma[A] = u.p + u.q * m[A];
    out.eps[A] = u.eps_v / 3 + 1.5 * u.eps_q * m[A];
    for (int B = 0; B < 3; ++B)
      out.D[A][B] = u.p_v + u.p_q * m[B] + m[A] * (u.q_v + u.q_q * m[B]) +
                    2.0 / 3 * spin * ((A == B) - 1.0 / 3 - 1.5 * m[A] * m[B]);
  }
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
  UpdateCounts counts;
  std::visit(
      [&](const auto& m) {
        for (std::size_t i = 0; i < out.size(); ++i) {
          const TrialInvariants trial = invariants(eps_trial[i]);
          const InvariantResponse u = respond(m, trial, phi_n[i]);
          to_principal(eps_trial[i], trial, u, out[i]);
          out[i].p = u.p;
          out[i].q = u.q;
          out[i].phi = u.phi;
          out[i].dv = trial.eps_v - u.eps_v;
          out[i].dw = trial.eps_q - u.eps_q;
          out[i].plastic_work = std::exp(u.eps_v) * (u.p * out[i].dv + u.q * out[i].dw);
          out[i].status = u.status;
          out[i].zone = u.zone;
          counts.plastic += u.status == Status::plastic || u.status == Status::bracketed;
          counts.bracketed += u.status == Status::bracketed;
          counts.refused += u.status == Status::refused;
        }
      },
      model);
  return counts;
}

double stored_energy(const Model& model, TrialInvariants elastic, double phi) {
  const Moduli m = std::visit([&](const auto& x) { return x.moduli(phi); }, model);
  return (m.K * elastic.eps_v * elastic.eps_v + 3 * m.G * elastic.eps_q * elastic.eps_q) / 2;
}

double plastic_volume_ratio(const Model& model, double phi) {
  const bool phi_is_volume = std::visit(
      []<class M>(const M&) {
        if constexpr (PlasticModel<M>) return M::phi_rate.v == -1 && M::phi_rate.w == 0;
        else return false;
      },
      model);
  return phi_is_volume ? std::exp(-phi) : 1;
}

double relative_density(const Model& model, double phi) {
  const auto* vmdc = std::get_if<Vmdc>(&model);
  return vmdc ? vmdc->rho_r(phi) : 1;
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
