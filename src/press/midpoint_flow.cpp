#include "press/midpoint_flow.hpp"

#include <algorithm>
#include <cmath>

namespace platen::press {
namespace {

/// Halfway is of second order; a little less keeps a point from flowing too much and too little by turns.
constexpr double ahead = 0.45;

} // namespace

fe::PointState continued(const fe::PointState& a, const fe::PointState& b, double factor) {
  const auto& [a_rr, a_zz, a_rz, a_tt] = a.Cp_inv;
  const auto& [b_rr, b_zz, b_rz, b_tt] = b.Cp_inv;
  // X = A^-1 B has the eigenvalues `high` and `low`, and X^factor = alpha + beta X (Cayley-Hamilton).
  const double det_a = a_rr * a_zz - a_rz * a_rz, det = (b_rr * b_zz - b_rz * b_rz) / det_a;
  const double mean = (a_zz * b_rr + a_rr * b_zz - 2 * a_rz * b_rz) / det_a / 2;
  const double half = std::sqrt(std::max(mean * mean - det, 0.0));
  const double high = mean + half, low = det / high, high_power = std::pow(high, factor);
  const double beta =
      half > 1e-9 * mean ? (high_power - std::pow(low, factor)) / (high - low) : factor * high_power / high;
  const double alpha = high_power - beta * high;
  fe::PointState c;
  for (int i = 0; i < 3; ++i) c.Cp_inv[i] = alpha * a.Cp_inv[i] + beta * b.Cp_inv[i];
  c.Cp_inv[3] = a_tt * std::pow(b_tt / a_tt, factor);
  c.phi = a.phi + factor * (b.phi - a.phi);
  return c;
}

PointFlow next_return(const PointFlow& last, double time, double next_time) {
  PointFlow next;
  next.start = last.state;
  next.start_time = time;
  const bool onward = (next_time - time) * (time - last.start_time) > 0;
  if (!last.steady || !onward) return next;
  next.start_time = time + ahead * (next_time - time);
  const double factor = (next.start_time - last.start_time) / (time - last.start_time);
  next.start = continued(last.start, last.state, factor);
  next.ahead_dv = (factor - 1) * last.dv;
  next.ahead_dw = (factor - 1) * last.dw;
  return next;
}

double accept(PointFlow& flow, const PointFlow& before, const fe::AxisymmetricSolid& solid, int point) {
  const material::PointUpdate& update = solid.updates[point];
  flow.flows = update.zone != material::Zone::elastic;
  flow.steady = flow.flows && before.flows;
  flow.dv = update.dv;
  flow.dw = update.dw;
  flow.elastic = material::invariants(update.eps);
  flow.state = solid.updated(point);
  flow.direction = solid.cauchy(point);
  for (const int normal : {0, 1, 3}) flow.direction[normal] -= update.p;
  // At an apex q is nothing but rounding, and has no direction.
  const double q_min = 1e-9 * std::abs(update.p) + 1e-300;
  for (double& component : flow.direction) component /= std::max(update.q, q_min);

  if (!flow.flows && flow.ahead_dv == 0 && flow.ahead_dw == 0) return 0;
  const auto power = [&](const material::TrialInvariants& elastic, double phi, double dv, double dw) {
    const auto m = std::visit([&](const auto& model) { return model.moduli(phi); }, solid.model);
    return material::plastic_volume_ratio(solid.model, phi) *
           (m.K * elastic.eps_v * dv + 3 * m.G * elastic.eps_q * dw);
  };
  // A point that was elastic flows from its yield on.
  const PointFlow& from = before.flows ? before : flow;
  const auto &a = from.direction, &b = flow.direction;
  const double turned = before.flows ? 1.5 * (a[0] * b[0] + a[1] * b[1] + 2 * a[2] * b[2] + a[3] * b[3]) : 1;
  const double there =
      power(from.elastic, from.state.phi, flow.ahead_dv + flow.dv, flow.ahead_dw + turned * flow.dw);
  const double here =
      power(flow.elastic, flow.state.phi, flow.ahead_dv + flow.dv, turned * flow.ahead_dw + flow.dw);
  const material::TrialInvariants middle{(from.elastic.eps_v + flow.elastic.eps_v) / 2,
                                         (from.elastic.eps_q + flow.elastic.eps_q) / 2};
  const auto energy = [&](double phi) {
    return material::plastic_volume_ratio(solid.model, phi) *
           material::stored_energy(solid.model, middle, phi);
  };
  return (there + here) / 2 - (energy(flow.state.phi) - energy(before.state.phi));
}

} // namespace platen::press
