#include "material/mohr_coulomb.hpp"

#include "core/error.hpp"
#include "core/number.hpp"
#include "material/card_section.hpp"
#include "material/integrator.hpp"
#include "material/principal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <optional>

namespace platen::material {
namespace {

using principal::Vector, principal::Matrix, principal::Elasticity, principal::dot;

constexpr double degree = std::numbers::pi / 180;

/// One plane of the yield surface: normal . sigma <= limit, flow along `flow`.
struct Plane {
  Vector normal, flow;
  double limit;
  bool tension;
};

/// For stresses in descending order: the shear planes of sigma_1 and sigma_3, 1 and 2, 2 and 3, and the
/// cut-off of each stress.
enum { shear_13, shear_12, shear_23, cut_1, cut_2, cut_3, planes_count };

/// Where the stress may end: a plane, an edge, a corner. At the corner sigma_1 = sigma_2 = T_0 four planes
/// meet, of which three carry the flow.
constexpr std::initializer_list<std::initializer_list<int>> places = {
    {shear_13},
    {cut_1},
    {shear_13, shear_12},
    {shear_13, shear_23},
    {cut_1, cut_2},
    {shear_13, cut_1},
    {shear_13, shear_12, cut_1},
    {shear_13, shear_23, cut_1},
    {shear_13, shear_23, cut_2},
    {shear_13, cut_1, cut_2},
    {shear_23, cut_1, cut_2},
    {cut_1, cut_2, cut_3},
};

std::array<Plane, planes_count> planes(const MohrCoulomb& m) {
  const double sin_phi = std::sin(m.phi_deg * degree), sin_psi = std::sin(m.psi_deg * degree);
  const double limit = 2 * m.cohesion * std::cos(m.phi_deg * degree);
  const auto shear = [&](int i, int j) {
    Plane plane{{}, {}, limit, false};
    plane.normal[i] = 1 + sin_phi, plane.normal[j] = sin_phi - 1;
    plane.flow[i] = 1 + sin_psi, plane.flow[j] = sin_psi - 1;
    return plane;
  };
  const auto cut = [&](int i) {
    Plane plane{{}, {}, m.cutoff, true};
    plane.normal[i] = plane.flow[i] = 1;
    return plane;
  };
  return {shear(0, 2), shear(0, 1), shear(1, 2), cut(0), cut(1), cut(2)};
}

/// Normal . D . flow of the active planes, filled up to 3x3 by the identity, as an inverse.
detail::Inverse3 coupling(const std::array<const Plane*, 3>& active, const Matrix& D) {
  Matrix M{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (int k = 0; k < 3 && active[k]; ++k)
    for (int l = 0; l < 3 && active[l]; ++l) {
      M[k][l] = 0;
      for (int A = 0; A < 3; ++A) M[k][l] += active[k]->normal[A] * dot(D[A], active[l]->flow);
    }
  return detail::Inverse3(M);
}

struct Return {
  Vector eps, sigma, multipliers{};
  Matrix D;
};

/// The return to the intersection of the active planes by Newton on the multipliers; false where it fails.
bool solve(const Elasticity& elastic, const Vector& trial, const std::array<const Plane*, 3>& active,
           double stress_tolerance, Return& r) {
  constexpr int iterations_max = 30;
  r.multipliers = {};
  for (int i = 0; i < iterations_max; ++i) {
    r.eps = trial;
    for (int k = 0; k < 3 && active[k]; ++k)
      for (int A = 0; A < 3; ++A) r.eps[A] -= r.multipliers[k] * active[k]->flow[A];
    r.sigma = elastic.stress(r.eps);
    r.D = elastic.tangent(r.eps, r.sigma);
    Vector gap{};
    for (int k = 0; k < 3 && active[k]; ++k) gap[k] = dot(active[k]->normal, r.sigma) - active[k]->limit;
    const double largest = std::max({std::abs(gap[0]), std::abs(gap[1]), std::abs(gap[2])});
    if (!std::isfinite(largest)) return false;
    if (largest <= stress_tolerance) return true;
    const Vector change = coupling(active, r.D).solve(gap);
    for (int k = 0; k < 3 && active[k]; ++k) r.multipliers[k] += change[k];
  }
  return false;
}

/// sigma_1 = p + high q, sigma_3 = p - low q.
YieldCurve meridian(const MohrCoulomb& m, const char* name, double high, double low, double p_low) {
  constexpr int points = 200;
  const double sin_phi = std::sin(m.phi_deg * degree), cos_phi = std::cos(m.phi_deg * degree);
  YieldCurve curve{name, {}};
  for (int i = 0; i <= points; ++i) {
    const double p = m.cutoff + (p_low - m.cutoff) * i / points;
    const double shear =
        (2 * m.cohesion * cos_phi - 2 * p * sin_phi) / (high * (1 + sin_phi) + low * (1 - sin_phi));
    curve.p_q.push_back({p, std::min(shear, (m.cutoff - p) / high)});
  }
  return curve;
}

} // namespace

std::vector<YieldCurve> MohrCoulomb::meridians(double p_low) const {
  return {meridian(*this, "triaxial compression", 1.0 / 3, 2.0 / 3, p_low),
          meridian(*this, "triaxial extension", 2.0 / 3, 1.0 / 3, p_low)};
}

double MohrCoulomb::reference_stress() const {
  return 2 * cohesion * std::cos(phi_deg * degree) / (1 - std::sin(phi_deg * degree));
}

double MohrCoulomb::excess(const Vector& sigma) const {
  const auto [low, high] = std::minmax_element(sigma.begin(), sigma.end());
  const double sin_phi = std::sin(phi_deg * degree);
  return std::max(*high * (1 + sin_phi) - *low * (1 - sin_phi) - 2 * cohesion * std::cos(phi_deg * degree),
                  *high - cutoff);
}

PrincipalResponse MohrCoulomb::respond(const Vector& eps_trial) const {
  constexpr double relative_strength_tolerance = 1e-12, relative_rounding = 1e-14; // of the trial stress
  const Moduli m = moduli(0);
  const Elasticity elastic{m.K - 2 * m.G / 3, m.G};
  std::array<int, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(), [&](int a, int b) { return eps_trial[a] > eps_trial[b]; });
  const Vector trial{eps_trial[order[0]], eps_trial[order[1]], eps_trial[order[2]]};
  const auto all = planes(*this);

  Return r{trial, elastic.stress(trial), {}, {}};
  r.D = elastic.tangent(trial, r.sigma);
  const double stress = std::max({std::abs(r.sigma[0]), std::abs(r.sigma[2]), cutoff});
  const double strength = std::max(all[shear_13].limit, cutoff);
  const double tolerance = relative_strength_tolerance * strength + relative_rounding * stress;
  const auto inside = [&](const Vector& sigma, double beyond) {
    return std::all_of(all.begin(), all.end(),
                       [&](const Plane& f) { return dot(f.normal, sigma) - f.limit <= beyond; });
  };

  PrincipalResponse out;
  std::array<const Plane*, 3> active{};
  if (!inside(r.sigma, 0)) {
    out.status = Status::refused;
    if (!std::isfinite(stress)) return out;
    for (const auto& place : places) {
      active = {};
      std::transform(place.begin(), place.end(), active.begin(), [&](int k) { return &all[k]; });
      if (!solve(elastic, trial, active, tolerance, r)) continue;
      const double least = *std::min_element(r.multipliers.begin(), r.multipliers.end());
      if (least < -100 * tolerance / m.G || !inside(r.sigma, 100 * tolerance)) continue;
      out.status = Status::plastic;
      break;
    }
    if (out.status == Status::refused) return out;
  }

  // D - D flow (normal D flow)^-1 normal D
  Matrix tangent = r.D;
  if (active[0]) {
    const auto inverse = coupling(active, r.D);
    for (int B = 0; B < 3; ++B) {
      Vector rise{};
      for (int k = 0; k < 3 && active[k]; ++k)
        for (int A = 0; A < 3; ++A) rise[k] += active[k]->normal[A] * r.D[A][B];
      const Vector rate = inverse.solve(rise);
      for (int A = 0; A < 3; ++A)
        for (int k = 0; k < 3 && active[k]; ++k) tangent[A][B] -= rate[k] * dot(r.D[A], active[k]->flow);
    }
    out.zone = Zone::shear;
    for (int k = 0; k < 3 && active[k]; ++k)
      if (active[k]->tension) out.zone = Zone::tension;
  }
  for (int A = 0; A < 3; ++A) {
    out.sigma[order[A]] = r.sigma[A];
    out.eps[order[A]] = r.eps[A];
    for (int B = 0; B < 3; ++B) out.D[order[A]][order[B]] = tangent[A][B];
  }
  return out;
}

// The card.

namespace {

using core::Field, core::positive, core::right_open;

/// The strength may be given in two ways, and is written by cohesion.
struct Given {
  double E = 0, nu = 0, phi = 0;
  std::optional<double> cohesion, sigma_c, psi;
  double cutoff = 0;
};

MohrCoulomb make(const core::Table& table, const Given& given) {
  const auto& [E, nu, phi, cohesion, sigma_c, psi, cutoff] = given;
  if (cohesion.has_value() == sigma_c.has_value())
    throw core::InvalidInput(fmt::format("{}: the strength needs exactly one of cohesion_Pa and sigma_c_Pa",
                                         core::place(table, "cohesion_Pa")));
  const double sin_phi = std::sin(phi * degree), cos_phi = std::cos(phi * degree);
  // C = sigma_c (1 - sin(phi))/(2 cos(phi)) (Wang et al., eq. 15).
  const double C = cohesion ? *cohesion : *sigma_c * (1 - sin_phi) / (2 * cos_phi);
  const MohrCoulomb m{E, nu, phi, C, psi.value_or(phi), cutoff};
  if (m.psi_deg > m.phi_deg)
    throw core::InvalidInput(fmt::format("{} = {} exceeds phi_deg = {}: plastic flow would give energy back",
                                         core::place(table, "psi_deg"), core::number_text(m.psi_deg),
                                         core::number_text(m.phi_deg)));
  if (m.cutoff * sin_phi >= m.cohesion * cos_phi)
    throw core::InvalidInput(
        fmt::format("{} = {} is not below the apex cohesion/tan(phi) = {} Pa: the cut-off would cut nothing",
                    core::place(table, "tension_cutoff_Pa"), core::number_text(m.cutoff),
                    core::number_text(m.cohesion * cos_phi / sin_phi)));
  return m;
}

Given given(const MohrCoulomb& m) { return {m.E, m.nu, m.phi_deg, m.cohesion, {}, m.psi_deg, m.cutoff}; }

} // namespace

const CardSection<MohrCoulomb>& MohrCoulomb::card() {
  static const auto section = section_of<MohrCoulomb, Given>(
      {
          {"E_Pa", &Given::E, "Young's modulus", positive},
          {"nu", &Given::nu, "Poisson's ratio", right_open(0, 0.5)},
          {"phi_deg", &Given::phi, "friction angle", right_open(0, 90)},
          {"cohesion_Pa", &Given::cohesion, "cohesion", positive},
          {"sigma_c_Pa", &Given::sigma_c, "uniaxial compressive strength", positive},
          Field<Given>{"psi_deg", &Given::psi, "dilation angle", right_open(0, 90)}.ruled(
              ", at most phi; left out: phi, associated flow"),
          Field<Given>{"tension_cutoff_Pa", &Given::cutoff, "largest principal stress", positive}.ruled(
              ", below the apex cohesion/tan(phi)"),
      },
      make, given, "Exactly one of cohesion_Pa and sigma_c_Pa.\n");
  return section;
}

} // namespace platen::material
