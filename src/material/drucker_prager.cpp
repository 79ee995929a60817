#include "material/drucker_prager.hpp"

#include "core/error.hpp"
#include "core/number.hpp"
#include "material/card_section.hpp"
#include "material/integrator.hpp"
#include "material/principal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace platen::material {

// Where the section is no circle. In the deviatoric plane, with the directions (2, -1, -1)/sqrt 6 and
// (0, 1, -1)/sqrt 2 as axes, theta is 0 in triaxial extension and 60 degrees in compression, cos(3 theta) =
// (r/q)^3, and t = sqrt(3/2) |s| h(theta). The elastic strain is parallel to the stress, so that of a trial
// deviator e and a multiplier g remain, along the radius and across it,
//
//   |e^e| = |e| cos(theta_tr - theta) - g c h,   0 = |e| sin(theta_tr - theta) - g c h',   c = sqrt(3/2)
//
// The second gives theta for a multiplier: its right side falls with theta as long as the section is convex.
// t + p tan(beta) then falls with g. Both are found by Newton's method between bounds. At g = g_apex the
// deviator has gone; who is beyond the strength still returns to the apex.
namespace {

using principal::Vector;

constexpr double third_of_pi = std::numbers::pi / 3;
const double c = std::sqrt(1.5);

struct Section {
  double K;
  double h(double theta) const { return (1 + 1 / K - (1 - 1 / K) * std::cos(3 * theta)) / 2; }
  double slope(double theta) const { return 1.5 * (1 - 1 / K) * std::sin(3 * theta); }
  /// h + h'', not negative where the section is convex.
  double bend(double theta) const { return (1 + 1 / K) / 2 + 4 * (1 - 1 / K) * std::cos(3 * theta); }
};

/// The zero of a function that falls between two bounds; f gives it and its derivative.
template <class F> double zero_of_falling(double low, double high, double start, const F& f) {
  double x = start;
  for (int i = 0; i < 100 && high - low > 1e-16 * (std::abs(low) + std::abs(high)); ++i) {
    const auto [value, slope] = f(x);
    if (value == 0) break;
    (value > 0 ? low : high) = x;
    double next = x - value / slope;
    if (!(next > low && next < high)) next = (low + high) / 2;
    if (std::abs(next - x) <= 1e-16 * std::abs(x)) break;
    x = next;
  }
  return x;
}

/// The deviator of three numbers in descending order.
struct Deviator {
  double size, theta;
  explicit Deviator(const Vector& e) {
    const double x = (2 * e[0] - e[1] - e[2]) / std::sqrt(6.0), y = (e[1] - e[2]) / std::sqrt(2.0);
    size = std::hypot(x, y);
    theta = std::atan2(y, x);
  }
};

Vector direction(double theta) {
  const double x = std::cos(theta) / std::sqrt(6.0), y = std::sin(theta) / std::sqrt(2.0);
  return {2 * x, y - x, -x - y};
}

/// Where a trial strain in descending order, outside of the surface, returns to.
struct ConeReturn {
  bool apex = false;
  double multiplier = 0, theta = 0, deviator = 0, eps_v = 0;
};

ConeReturn return_to_cone(const DruckerPrager::Surface& f, const Section& section, const Moduli& m,
                          const Vector& trial) {
  const double v = trial[0] + trial[1] + trial[2];
  const Deviator e(trial);
  const auto pressure_excess = [&](double g) {             // of p tan(beta) - d
    const double eps_v = std::min(v - g * f.tan_psi, 1.0); // beyond, the elastic law falls
    return m.K * eps_v * std::exp(-eps_v) * f.tan_beta - f.d;
  };
  const double theta_apex = zero_of_falling(e.theta, third_of_pi, e.theta, [&](double theta) {
    const double turn = e.theta - theta;
    return std::pair{std::sin(turn) * section.h(theta) - std::cos(turn) * section.slope(theta),
                     -std::cos(turn) * section.bend(theta)};
  });
  const double g_apex = e.size * std::cos(e.theta - theta_apex) / (c * section.h(theta_apex));
  if (pressure_excess(g_apex) >= 0) return {true};

  ConeReturn r;
  const auto turn_for = [&](double g) {
    return zero_of_falling(e.theta, third_of_pi, r.theta, [&](double theta) {
      const double turn = e.theta - theta;
      return std::pair{e.size * std::sin(turn) - g * c * section.slope(theta),
                       -e.size * std::cos(turn) - g * c * (section.bend(theta) - section.h(theta))};
    });
  };
  r.theta = e.theta;
  r.multiplier = zero_of_falling(0, g_apex, 0, [&](double g) {
    r.theta = turn_for(g);
    const double h = section.h(r.theta), eps_v = v - g * f.tan_psi, exp_v = std::exp(-eps_v);
    r.deviator = std::max(e.size * std::cos(e.theta - r.theta) - g * c * h, 0.0);
    const double t = 2 * m.G * exp_v * c * r.deviator * h;
    // dt/dg without the turn, which only steepens it
    return std::pair{t + pressure_excess(g), -2 * m.G * exp_v * 1.5 * h * h + t * f.tan_psi -
                                                 m.K * (1 - eps_v) * exp_v * f.tan_psi * f.tan_beta};
  });
  r.theta = turn_for(r.multiplier);
  r.deviator = e.size * std::cos(e.theta - r.theta) - r.multiplier * c * section.h(r.theta);
  r.eps_v = v - r.multiplier * f.tan_psi;
  return r;
}

} // namespace

double DruckerPrager::excess(const Vector& sigma) const {
  Vector s = sigma;
  std::ranges::sort(s, std::greater());
  const Deviator deviator(s);
  const Surface f = surface(0);
  return c * deviator.size * Section{flow_stress_ratio}.h(deviator.theta) +
         (s[0] + s[1] + s[2]) / 3 * f.tan_beta - f.d;
}

PrincipalResponse DruckerPrager::respond(const Vector& eps_trial) const {
  const Moduli m = moduli(0);
  const Surface f = surface(0);
  const Section section{flow_stress_ratio};
  const principal::Elasticity elastic{m.K - 2 * m.G / 3, m.G};
  PrincipalResponse out{.sigma = elastic.stress(eps_trial), .eps = eps_trial};
  out.D = elastic.tangent(out.eps, out.sigma);
  const double outside = excess(out.sigma);
  if (outside <= 0) return out;
  out.status = Status::refused;
  if (!std::isfinite(outside)) return out;

  std::array<int, 3> order{0, 1, 2};
  std::ranges::sort(order, [&](int a, int b) { return eps_trial[a] > eps_trial[b]; });
  const ConeReturn r =
      return_to_cone(f, section, m, {eps_trial[order[0]], eps_trial[order[1]], eps_trial[order[2]]});
  if (r.apex) {
    const double largest_v = detail::volumetric_strain(f.p_apex(), m.K);
    if (!std::isfinite(largest_v)) return out; // the elastic law has no such tension
    out.status = Status::plastic;
    out.zone = Zone::tension;
    out.eps.fill(largest_v / 3);
    out.sigma.fill(f.p_apex());
    out.D = {};
    return out;
  }
  out.status = Status::plastic;

  const Vector along = direction(r.theta), across = direction(r.theta + std::numbers::pi / 2);
  const double h = section.h(r.theta), slope = section.slope(r.theta);
  // deps = A (deps_tr - n dg), A = 1 - share across (x) across: the flow turns with the stress.
  const double turning = r.multiplier * c * section.bend(r.theta);
  const double share = turning / (turning + r.deviator);
  Vector eps{}, normal{}, flow{};
  for (int A = 0; A < 3; ++A) {
    eps[A] = r.eps_v / 3 + r.deviator * along[A];
    const double gradient = c * (h * along[A] + slope * across[A]);
    normal[A] = gradient + f.tan_beta / 3;
    flow[A] = gradient + f.tan_psi / 3;
  }
  const Vector sigma = elastic.stress(eps);
  const principal::Matrix D = elastic.tangent(eps, sigma);
  const auto turned = [&](Vector x) {
    const double part = share * principal::dot(across, x);
    for (int A = 0; A < 3; ++A) x[A] -= part * across[A];
    return x;
  };
  Vector rise{};
  for (int B = 0; B < 3; ++B)
    for (int A = 0; A < 3; ++A) rise[B] += normal[A] * D[A][B];
  const Vector turned_flow = turned(flow), turned_rise = turned(rise);
  const double per_rise = 1 / principal::dot(rise, turned_flow);
  principal::Matrix strain; // d(eps)/d(eps_tr)
  for (int A = 0; A < 3; ++A)
    for (int B = 0; B < 3; ++B)
      strain[A][B] = (A == B) - share * across[A] * across[B] - turned_flow[A] * turned_rise[B] * per_rise;
  for (int A = 0; A < 3; ++A) {
    out.sigma[order[A]] = sigma[A];
    out.eps[order[A]] = eps[A];
    for (int B = 0; B < 3; ++B) {
      double d = 0;
      for (int C = 0; C < 3; ++C) d += D[A][C] * strain[C][B];
      out.D[order[A]][order[B]] = d;
    }
  }
  out.zone = Zone::shear;
  return out;
}

std::vector<YieldCurve> DruckerPrager::meridians(double p_low) const {
  const Surface f = surface(0);
  const Section section{flow_stress_ratio};
  const auto meridian = [&](const char* of, double theta) {
    const double q_low = (f.d - p_low * f.tan_beta) / section.h(theta);
    return YieldCurve{of, {{f.p_apex(), 0}, {p_low, std::max(q_low, 0.0)}}};
  };
  return {meridian("triaxial compression", third_of_pi), meridian("triaxial extension", 0)};
}

// The card.

namespace {

using core::Field, core::positive, core::right_open;

/// atan 3, beyond which sigma_c (1 - tan(beta)/3) = d is negative; reached at phi = 90 degrees.
const double beta_max = std::atan(3.0) * 180 / std::numbers::pi;

/// The strength may be given in three ways, and is written in the first.
struct Given {
  double E = 0, nu = 0;
  std::optional<double> beta, phi, sigma_c, cohesion, psi, K;
};

DruckerPrager make(const core::Table& table, const Given& given) {
  const auto& [E, nu, beta, phi, sigma_c, cohesion, psi, K] = given;
  if (beta.has_value() == phi.has_value() || sigma_c.has_value() == cohesion.has_value() ||
      (beta && cohesion))
    throw core::InvalidInput(fmt::format("{}: the strength needs exactly one of beta_deg with sigma_c_Pa, "
                                         "phi_deg with sigma_c_Pa, phi_deg with cohesion_Pa",
                                         core::place(table, beta ? "beta_deg" : "phi_deg")));
  DruckerPrager m{};
  m.E = E;
  m.nu = nu;
  m.beta_deg = beta ? *beta : DruckerPrager::beta_of_friction(*phi);
  m.sigma_c = sigma_c ? *sigma_c : DruckerPrager::strength_of_cohesion(*cohesion, *phi);
  m.psi_deg = psi.value_or(m.beta_deg);
  m.flow_stress_ratio = K.value_or(1);
  if (m.psi_deg > m.beta_deg)
    throw core::InvalidInput(fmt::format(
        "{} = {} exceeds the friction angle beta = {} in the (p, q) plane: plastic flow would give "
        "energy back",
        core::place(table, "psi_deg"), core::number_text(m.psi_deg), core::number_text(m.beta_deg)));
  return m;
}

Given given(const DruckerPrager& m) {
  const auto K = m.circular() ? std::nullopt : std::optional(m.flow_stress_ratio);
  return {m.E, m.nu, m.beta_deg, {}, m.sigma_c, {}, m.psi_deg, K};
}

} // namespace

const CardSection<DruckerPrager>& DruckerPrager::card() {
  static const auto section = section_of<DruckerPrager, Given>(
      {
          {"E_Pa", &Given::E, "Young's modulus", positive},
          {"nu", &Given::nu, "Poisson's ratio", right_open(0, 0.5)},
          Field<Given>{"beta_deg", &Given::beta, "friction angle in the (p, q) plane",
                       core::Interval{.low = 0, .high = beta_max}}
              .ruled(", below atan 3; with sigma_c_Pa"),
          {"phi_deg", &Given::phi, "friction angle of triaxial compression; with sigma_c_Pa or cohesion_Pa",
           core::Interval{.low = 0, .high = 90}},
          {"sigma_c_Pa", &Given::sigma_c, "uniaxial compressive strength", positive},
          {"cohesion_Pa", &Given::cohesion, "cohesion of Mohr and Coulomb", positive},
          Field<Given>{"psi_deg", &Given::psi, "dilation angle in the (p, q) plane", right_open(0, beta_max)}
              .ruled(", at most beta; left out: beta, associated flow"),
          Field<Given>{"flow_stress_ratio", &Given::K,
                       "K, strength in triaxial extension over that in compression", core::closed(7.0 / 9, 1)}
              .ruled("; left out: 1, a circle"),
      },
      make, given, "Exactly one of beta_deg + sigma_c_Pa, phi_deg + sigma_c_Pa, phi_deg + cohesion_Pa.\n");
  return section;
}

} // namespace platen::material
