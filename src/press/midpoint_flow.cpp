#include "press/midpoint_flow.hpp"

#include <algorithm>
#include <cmath>

namespace platen::press {
namespace {

/// Halfway is of second order; a little less keeps a point from flowing too much and too little by turns.
constexpr double ahead = 0.45;

/// Of axisymmetric tensors rr, zz, rz, tt, and of xx, yy, zz, xy, yz, zx.
double contraction(const std::array<double, 4>& a, const std::array<double, 4>& b) {
  return a[0] * b[0] + a[1] * b[1] + 2 * a[2] * b[2] + a[3] * b[3];
}
double contraction(const fe::Symmetric3& a, const fe::Symmetric3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + 2 * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]);
}
void subtract_mean(std::array<double, 4>& t, double mean) {
  for (const int normal : {0, 1, 3}) t[normal] -= mean;
}
void subtract_mean(fe::Symmetric3& t, double mean) {
  for (const int normal : {0, 1, 2}) t[normal] -= mean;
}

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

// With A = L L^T and M = L^-1 B L^-T it is L M^factor L^T.
fe::SpatialPointState continued(const fe::SpatialPointState& a, const fe::SpatialPointState& b,
                                double factor) {
  const auto& [xx, yy, zz, xy, yz, zx] = a.Cp_inv;
  const double l00 = std::sqrt(xx), l10 = xy / l00, l20 = zx / l00, l11 = std::sqrt(yy - l10 * l10),
               l21 = (yz - l20 * l10) / l11, l22 = std::sqrt(zz - l20 * l20 - l21 * l21);
  // Columns of L^-1 B, then rows of that times L^-T.
  const auto forward = [&](double x, double y, double z) {
    const double p = x / l00, q = (y - l10 * p) / l11;
    return fe::Vector3{p, q, (z - l20 * p - l21 * q) / l22};
  };
  const auto& B = b.Cp_inv;
  const fe::Vector3 c0 = forward(B[0], B[3], B[5]), c1 = forward(B[3], B[1], B[4]),
                    c2 = forward(B[5], B[4], B[2]);
  const fe::Vector3 r0 = forward(c0[0], c1[0], c2[0]), r1 = forward(c0[1], c1[1], c2[1]),
                    r2 = forward(c0[2], c1[2], c2[2]);
  fe::Spectral m = fe::spectral({r0[0], r1[1], r2[2], r0[1], r1[2], r2[0]});
  for (int k = 0; k < 3; ++k) {
    m.value[k] = std::pow(m.value[k], factor);
    const auto& [x, y, z] = m.axis[k];
    m.axis[k] = {l00 * x, l10 * x + l11 * y, l20 * x + l21 * y + l22 * z};
  }
  return {fe::compose(m.value, m.axis), a.phi + factor * (b.phi - a.phi)};
}

template <class Solid>
PointFlow<Solid> next_return(const PointFlow<Solid>& last, double time, double next_time) {
  PointFlow<Solid> next;
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

template <class Solid>
double accept(PointFlow<Solid>& flow, const PointFlow<Solid>& before, const Solid& solid, int point) {
  const material::PointUpdate& update = solid.updates[point];
  flow.flows = update.zone != material::Zone::elastic;
  flow.steady = flow.flows && before.flows;
  flow.dv = update.dv;
  flow.dw = update.dw;
  flow.elastic = material::invariants(update.eps);
  flow.state = solid.updated(point);
  flow.direction = solid.cauchy(point);
  subtract_mean(flow.direction, update.p);
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
  const PointFlow<Solid>& from = before.flows ? before : flow;
  const auto &a = from.direction, &b = flow.direction;
  const double turned = before.flows ? 1.5 * contraction(a, b) : 1;
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

template PointFlow<fe::AxisymmetricSolid> next_return(const PointFlow<fe::AxisymmetricSolid>&, double,
                                                      double);
template double accept(PointFlow<fe::AxisymmetricSolid>&, const PointFlow<fe::AxisymmetricSolid>&,
                       const fe::AxisymmetricSolid&, int);
template PointFlow<fe::HexahedralSolid> next_return(const PointFlow<fe::HexahedralSolid>&, double, double);
template double accept(PointFlow<fe::HexahedralSolid>&, const PointFlow<fe::HexahedralSolid>&,
                       const fe::HexahedralSolid&, int);

} // namespace platen::press
