#include "press/flow.hpp"

#include "fe/hexahedron.hpp"
#include "fe/quad.hpp"

#include <algorithm>
#include <cmath>

namespace platen::press {
namespace {

/// Halfway is of second order; a little less keeps a point from flowing too much and too little by turns.
constexpr double ahead = 0.45;

} // namespace

template <fe::Element E> PointFlow<E> next_return(const PointFlow<E>& last, double time, double next_time) {
  PointFlow<E> next;
  next.start = last.state;
  next.start_time = time;
  const bool onward = (next_time - time) * (time - last.start_time) > 0;
  if (!last.steady || !onward) return next;
  next.start_time = time + ahead * (next_time - time);
  const double factor = (next.start_time - last.start_time) / (time - last.start_time);
  next.start = E::continued(last.start, last.state, factor);
  next.ahead_dv = (factor - 1) * last.dv;
  next.ahead_dw = (factor - 1) * last.dw;
  return next;
}

double working_shear(double ahead, double dw, double cos_phi) {
  if (cos_phi < 0) return (ahead + dw) * (1 + cos_phi) / 2;
  cos_phi = std::min(cos_phi, 1.0);
  const double half = std::acos(cos_phi) / 2;
  const double way = std::sqrt(ahead * ahead + dw * dw + 2 * ahead * dw * cos_phi);
  return half > 0 ? way * half / std::sin(half) : way;
}

template <fe::Element E>
double accept(PointFlow<E>& flow, const PointFlow<E>& before, const material::Model& model,
              const fe::Response<E>& response, int point) {
  const material::PointUpdate& update = response.updates[point];
  flow.flows = update.zone != material::Zone::elastic;
  flow.steady = flow.flows && before.flows;
  flow.dv = update.dv;
  flow.dw = update.dw;
  flow.elastic = material::invariants(update.eps);
  flow.state = response.state(point);
  flow.direction = response.cauchy(point);
  for (const int normal : E::normal_components) flow.direction[normal] -= update.p;
  // At an apex q is nothing but rounding, and has no direction.
  const double q_min = 1e-9 * std::abs(update.p) + 1e-300;
  for (double& component : flow.direction) component /= std::max(update.q, q_min);

  flow.F = E::gradient(response.kinematics[point / E::points], point % E::points);

  if (!flow.flows && flow.ahead_dv == 0 && flow.ahead_dw == 0) return 0;
  // A point that was elastic flows from its yield on.
  const PointFlow<E>& from = before.flows ? before : flow;
  const double cos_phi =
      before.flows ? 1.5 * E::contraction(E::turned(from.direction, from.F, flow.F), flow.direction) : 1;
  const double dv = flow.ahead_dv + flow.dv, dw = working_shear(flow.ahead_dw, flow.dw, cos_phi);
  const auto work = [&](const PointFlow<E>& end) {
    const auto moduli = std::visit([&](const auto& m) { return m.moduli(end.state.phi); }, model);
    return material::plastic_volume_ratio(model, end.state.phi) *
           (moduli.K * end.elastic.eps_v * dv + 3 * moduli.G * end.elastic.eps_q * dw);
  };
  const material::TrialInvariants middle{(from.elastic.eps_v + flow.elastic.eps_v) / 2,
                                         (from.elastic.eps_q + flow.elastic.eps_q) / 2};
  const auto energy = [&](double phi) {
    return material::plastic_volume_ratio(model, phi) * material::stored_energy(model, middle, phi);
  };
  return (work(from) + work(flow)) / 2 - (energy(flow.state.phi) - energy(before.state.phi));
}

template PointFlow<fe::Quad> next_return(const PointFlow<fe::Quad>&, double, double);
template PointFlow<fe::Hexahedron> next_return(const PointFlow<fe::Hexahedron>&, double, double);
template double accept(PointFlow<fe::Quad>&, const PointFlow<fe::Quad>&, const material::Model&,
                       const fe::Response<fe::Quad>&, int);
template double accept(PointFlow<fe::Hexahedron>&, const PointFlow<fe::Hexahedron>&, const material::Model&,
                       const fe::Response<fe::Hexahedron>&, int);

} // namespace platen::press
