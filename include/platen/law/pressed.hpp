#pragma once
// The curve of the press (or of a measurement) itself as a law: force, contact radius and unloading of one
// sphere between rigid planes at up to 64 knots.
//
//   F = pi R^2 sigma_ref F_bar(delta/R),  a = R a_bar(delta/R)
//   unloading (9)-(14) of Edmans & Sinka: F_max xi^alpha, beta = gamma_Hertz/(gamma_max - gamma_0), over
//   delta/R
//
// C1 and monotone in the logarithms between knots. Below the first one Hertz, reached along the power with
// which the curve begins; beyond the last the tangent. Unlike bodies: joined.hpp.

#include "platen/law/joined.hpp"
#include "platen/law/parameter_reader.hpp"

namespace platen::law {

struct PressedMaterial {
  static constexpr std::size_t most_knots = 64;
  double E = 0;         ///< Young's modulus; infinity: a rigid body, without a curve [Pa]
  double nu = 0;        ///< Poisson's ratio, in [0, 0.5)
  double sigma_ref = 0; ///< stress that makes F_bar dimensionless [Pa]
  std::vector<double> delta_bar, F_bar, a_bar;
  std::vector<double> unload_delta_bar, alpha,
      beta; ///< may be empty: Hertz's exponent and both bodies' elasticity

  static LawInfo info() {
    return {"pressed",
            "the curve of the press itself",
            "Platen: force, contact radius and unloading at knots; unloading as Edmans & Sinka (9)-(14)",
            "to the last knot; unlike bodies: see docs/explanation/joined.md",
            "c1",
            {{"sigma_ref_Pa", "stress that makes the force dimensionless", positive},
             youngs_modulus(),
             poissons_ratio()},
            {{"delta_bar", "knots in delta/R, growing, 4 to 64", ""},
             {"F_bar", "force there over pi R^2 sigma_ref, growing", ""},
             {"a_bar", "contact radius there over R, growing", ""},
             {"unload_delta_bar", "delta/R at which alpha and beta are given", ""},
             {"alpha", "unloading exponents (9)", ""},
             {"beta", "secant stiffness ratios (11)", ""}}};
  }
  static PressedMaterial read(const Reader& p) {
    return {p("E_Pa"),
            p("nu"),
            p("sigma_ref_Pa"),
            p.numbers("delta_bar"),
            p.numbers("F_bar"),
            p.numbers("a_bar"),
            p.numbers("unload_delta_bar"),
            p.numbers("alpha"),
            p.numbers("beta")};
  }
  bool operator==(const PressedMaterial&) const = default;
};

namespace detail {

inline void check(const PressedMaterial& m) {
  constexpr auto name = "pressed";
  require(name, "E_Pa", m.E, positive);
  require(name, "nu", m.nu, poisson);
  require(name, "sigma_ref_Pa", m.sigma_ref, positive);
  const std::size_t n = m.delta_bar.size();
  require(name, "number of delta_bar", static_cast<double>(n), {4, PressedMaterial::most_knots});
  if (m.F_bar.size() != n || m.a_bar.size() != n)
    throw BadParameter("pressed: delta_bar, F_bar and a_bar must have as many values each");
  for (std::size_t i = 0; i < n; ++i) {
    const auto after = [&](const std::vector<double>& v) {
      return Range{i ? v[i - 1] : 0, infinity, true, true};
    };
    require(name, "delta_bar", m.delta_bar[i], after(m.delta_bar));
    require(name, "F_bar", m.F_bar[i], after(m.F_bar));
    require(name, "a_bar", m.a_bar[i], {i ? m.a_bar[i - 1] : 0, infinity, i == 0, true});
  }
  require(name, "delta_bar", m.delta_bar.back(), {0, 1, true, true});
  const std::size_t u = m.unload_delta_bar.size();
  if (m.alpha.size() != u || m.beta.size() != u)
    throw BadParameter("pressed: unload_delta_bar, alpha and beta must have as many values each");
  for (std::size_t i = 0; i < u; ++i) {
    require(name, "unload_delta_bar", m.unload_delta_bar[i],
            {i ? m.unload_delta_bar[i - 1] : 0, infinity, true, true});
    require(name, "alpha", m.alpha[i], {1, 10});
    require(name, "beta", m.beta[i], positive);
  }
}

/// One material against a rigid plane, or what is the same, its like.
inline KnotCurve prepare_like(const PressedMaterial& m, const Pair& pair) {
  const double E_flat = pair.E_star * pair.sharing(); // E/(1 - nu^2)
  const auto hertz = [&](double x) { return 4.0 / 3 * E_flat * x * std::sqrt(x); };
  std::vector<Knot> knots;
  const std::size_t n = m.delta_bar.size();
  for (std::size_t i = 0; i < n; ++i)
    knots.push_back({m.delta_bar[i], std::numbers::pi * m.sigma_ref * m.F_bar[i], m.a_bar[i]});
  // Where it leaves Hertz: of a curve that begins below, where its first power comes down to it; else its
  // first knot.
  const Knot first = knots.front();
  double n_first = 1.5, x_yield = first.x;
  if (first.F < 0.9 * hertz(first.x)) {
    const double begin = std::log(knots[1].F / first.F) / std::log(knots[1].x / first.x);
    n_first = std::clamp(begin, 1.0, 1.45);
    x_yield = first.x * std::pow(first.F / hertz(first.x), 1 / (1.5 - n_first));
    Knot yield = first;
    yield.x = std::max(x_yield, 1e-3 * first.x);
    yield.F = first.F * std::pow(yield.x / first.x, n_first);
    yield.a = first.a * std::sqrt(yield.x / first.x);
    knots.insert(knots.begin(), yield);
    n_first = 1.5;
  } else
    for (const Knot& k : knots)
      if (k.F > 0.97 * hertz(k.x)) x_yield = k.x;
      else break;
  // A finite sphere is stiffer than Hertz's: what unloading was seen to do says more of where it is elastic.
  if (!m.alpha.empty()) x_yield = std::min(x_yield, 0.25 * m.unload_delta_bar.front());
  // Unloading: from Hertz's own at yield over the measured ones, linear in ln x.
  std::vector<double> u{std::log(x_yield)}, alpha{1.5}, beta{1};
  for (std::size_t i = 0; i < m.alpha.size(); ++i)
    if (std::log(m.unload_delta_bar[i]) > u.back() + 1e-6)
      u.push_back(std::log(m.unload_delta_bar[i])), alpha.push_back(m.alpha[i]), beta.push_back(m.beta[i]);
  const auto linear = [&](const std::vector<double>& y, double at) {
    if (at <= u.front()) return y.front();
    if (at >= u.back()) return y.back();
    std::size_t i = 0;
    while (u[i + 1] < at) ++i;
    return y[i] + (y[i + 1] - y[i]) * (at - u[i]) / (u[i + 1] - u[i]);
  };
  for (Knot& k : knots) {
    if (m.alpha.empty()) {
      const double fade = k.x > x_yield ? 1 - x_yield / k.x : 0;
      k.S = pair.unloading_slope(k.a * pair.R_e, fade) / pair.x_per_gamma / (pair.R_e * pair.R_e);
      continue;
    }
    k.alpha = linear(alpha, std::log(k.x));
    const double x_hertz = std::cbrt(std::pow(0.75 * k.F / E_flat, 2));
    k.S = k.alpha * linear(beta, std::log(k.x)) * k.F / x_hertz;
  }
  return {pair, knots, n_first, true, {0, m.delta_bar.back()}};
}

inline Pair like_pair(const PressedMaterial& m) {
  return make_pair(sphere(1, m.E, m.nu), sphere(1, m.E, m.nu));
}

} // namespace detail

inline KnotCurve prepare(const PressedMaterial& m1, double R1, const PressedMaterial& m2, double R2) {
  const bool rigid1 = m1.E == infinity, rigid2 = m2.E == infinity;
  if (rigid1 && rigid2) throw BadParameter("pressed: E_Pa of the softer side = inf is not in (0, inf)");
  if (!rigid1) detail::check(m1);
  if (!rigid2) detail::check(m2);
  require("pressed", "radius_m", R1, radius_or_plane);
  require("pressed", "radius2_m", R2, radius_or_plane);
  const Pair pair = make_pair(sphere(R1, m1.E, m1.nu), sphere(R2, m2.E, m2.nu));
  const bool rigid_plane = (rigid1 && R1 == infinity) || (rigid2 && R2 == infinity);
  if (rigid_plane || (m1 == m2 && R1 == R2)) return detail::prepare_like(rigid1 ? m2 : m1, pair);
  std::shared_ptr<const Table> table1, table2;
  JoinedSide one, two;
  if (!rigid1) {
    table1 = tabulate(detail::prepare_like(m1, detail::like_pair(m1))).table;
    one = {table1.get(), m1.delta_bar.back()};
  }
  if (!rigid2) {
    table2 = m1 == m2 ? table1 : tabulate(detail::prepare_like(m2, detail::like_pair(m2))).table;
    two = {table2.get(), m2.delta_bar.back()};
  }
  return join(pair, one, two);
}

inline KnotCurve prepare_on_rigid_plane(const PressedMaterial& m, double R) {
  PressedMaterial rigid;
  rigid.E = infinity;
  return prepare(m, R, rigid, infinity);
}

} // namespace platen::law
