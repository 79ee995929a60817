#pragma once
// Compressible plastic particles: a linear, then exponential law fitted to finite-element curves.
// Edmans & Sinka, "Numerical derivation of a normal contact law for compressible plastic particles":
// loading (6), unloading (9)-(14). Which material gives which parameters: edmans_sinka_appendix.hpp.
//
//   F_bar = k x                          x <= delta_t           x = delta/R, F_bar = F/(pi R^2 sigma_ref)
//   F_bar = k delta_t exp(a (x-delta_t))  x >  delta_t                                               (6)
//
// Valid for x <= 0.5. The paper gives no contact radius: ours is what the material's press had at a few
// overlaps; where it is not given, a metal's (docs/laws/edmans-sinka.md).

#include "platen/law/contact.hpp"
#include "platen/law/edmans_sinka_appendix.hpp"
#include "platen/law/edmans_sinka_curve.hpp"
#include "platen/law/pair.hpp"
#include "platen/law/parameter_reader.hpp"
#include "platen/law/radius_points.hpp"
#include "platen/law/radius_polynomial.hpp"

#include <algorithm>
#include <tuple>
#include <vector>

namespace platen::law {

/// Ours: least squares of a/(R sqrt(x)) to independent finite elements (von Mises, E/sigma_y = 100, x from
/// 0.05 to 0.5); within 2.2 % there, 10 % too large at x = 0.02, where the contact is still half elastic.
inline constexpr RadiusPolynomial<double> edmans_sinka_radius{1.455, 0.973, 1.640};

/// One particle material as a law card writes it.
struct EdmansSinkaMaterial {
  double sigma_ref = 0; ///< stress that makes F dimensionless, the yield stress of the material card [Pa]
  double E = 0;         ///< Young's modulus, for unloading [Pa]
  double nu = 0;        ///< Poisson's ratio, in [0, 0.5)
  double k = 0;         ///< (6) [-]
  double delta_t = 0;   ///< (6), in delta/R [-]
  double a = 0;         ///< (6) [-]
  EdmansSinkaVariant variant = EdmansSinkaVariant::published;
  double corner = 0.5; ///< c1 only, see EdmansSinkaCurve

  /// Contact radius over R at these delta/R. None: edmans_sinka_radius.
  static constexpr int most_radii = RadiusPoints<double>::most;
  int radii = 0;
  double radius_delta_bar[most_radii] = {};
  double a_bar[most_radii] = {};

  /// Unloading (9)-(14): alpha and the secant stiffness ratio beta (11) at these delta_bar, linear between,
  /// held outside. None: the generic unloading of contact.hpp.
  static constexpr int most_unloadings = 8;
  int unloadings = 0;
  double unload_delta_bar[most_unloadings] = {};
  double alpha[most_unloadings] = {};
  double beta[most_unloadings] = {};

  static LawInfo info() {
    return {
        "edmans-sinka",
        "compressible plastic particles, fitted curve",
        "Edmans & Sinka (6), (9)-(14)",
        "delta/R <= 0.5",
        "published|c1|hertz-like",
        {{"sigma_ref_Pa", "stress that makes the force dimensionless: the material's yield stress", positive},
         youngs_modulus(),
         poissons_ratio(),
         {"k", "(6), initial slope of F/(pi R^2 sigma_ref) over delta/R", positive},
         {"delta_t", "(6), end of the first branch in delta/R", {0, 1, true, false}},
         {"a", "(6), rate of the exponential branch", {0, 50, true, false}},
         {"Gamma_bar",
          "shear over compressive strength, instead of k, delta_t and a: Appendix A at E_Pa/sigma_ref_Pa",
          {0.25, 1},
          Of::pair,
          0},
         {"corner", "c1: half-width of the rounded corner over delta_t", {0, 1, true, true}, Of::pair, 0.5}},
        {{"radius_delta_bar", "delta/R at which the contact radius is given, at most 8", ""},
         {"a_bar", "contact radius there over R, never falling", ""},
         {"unload_delta_bar", "delta/R at which alpha and beta are given, at most 8", ""},
         {"alpha", "unloading exponents (9)", ""},
         {"beta", "secant stiffness ratios (11)", ""}}};
  }
  static EdmansSinkaMaterial read(const Reader& p) {
    EdmansSinkaMaterial m;
    m.sigma_ref = p("sigma_ref_Pa"), m.E = p("E_Pa"), m.nu = p("nu");
    m.corner = p("corner");
    if (p.given("Gamma_bar")) {
      for (const char* key : {"k", "delta_t", "a"})
        if (p.given(key))
          throw BadParameter("edmans-sinka: Gamma_bar says k, delta_t and a: leave either out");
      const AppendixA from =
          edmans_sinka_appendix(p("Gamma_bar"), m.E / m.sigma_ref, Coefficients::corrected);
      if (!from.in_range)
        throw BadParameter(
            "edmans-sinka: Appendix A holds for E_Pa/sigma_ref_Pa from 4.5 to 500, and this is " +
            text(m.E / m.sigma_ref));
      m.k = from.k, m.delta_t = from.delta_t, m.a = from.a;
    } else m.k = p("k"), m.delta_t = p("delta_t"), m.a = p("a");
    m.variant = p.variant == "c1"           ? EdmansSinkaVariant::c1
                : p.variant == "hertz-like" ? EdmansSinkaVariant::hertz_like
                                            : EdmansSinkaVariant::published;
    if (m.variant == EdmansSinkaVariant::c1 && !p.given("corner"))
      m.corner = smaller(0.5, 0.8 / (m.a * m.delta_t));
    const auto count = [](const char* key, const std::vector<double>& values, int most) {
      require("edmans-sinka", key, static_cast<double>(values.size()), {0, static_cast<double>(most)});
      return static_cast<int>(values.size());
    };
    const auto at = p.numbers("radius_delta_bar"), a_bars = p.numbers("a_bar");
    if (at.size() != a_bars.size())
      throw BadParameter("edmans-sinka: radius_delta_bar and a_bar must have as many values each");
    m.radii = count("number of radius_delta_bar", at, most_radii);
    std::copy(at.begin(), at.end(), m.radius_delta_bar);
    std::copy(a_bars.begin(), a_bars.end(), m.a_bar);
    const auto x = p.numbers("unload_delta_bar"), alphas = p.numbers("alpha"), betas = p.numbers("beta");
    if (x.size() != alphas.size() || x.size() != betas.size())
      throw BadParameter("edmans-sinka: unload_delta_bar, alpha and beta must have as many values each");
    m.unloadings = count("number of unload_delta_bar", x, most_unloadings);
    std::copy(x.begin(), x.end(), m.unload_delta_bar);
    std::copy(alphas.begin(), alphas.end(), m.alpha);
    std::copy(betas.begin(), betas.end(), m.beta);
    return m;
  }
};

template <class Real = double> struct EdmansSinka {
  using Scalar = Real;
  EdmansSinkaCurve<Real> curve;
  RadiusPoints<Real> radius;
  Real steepest_in_corner{}; ///< of the rounded corner, c1 only
  Real radius_log_slope{};   ///< least d ln a / d ln x below x_end, hence of the unloading slope
  BasicPair<Real> pair;
  Real x_valid = Real(EdmansSinkaCurve<Real>::x_valid);
  Real force_scale{};   ///< pi R_e^2 sigma_ref [N]
  Real gamma_elastic{}; ///< 0: the law has no elastic range
  Real gamma_limit{};
  int unloadings = 0;
  Real unload_x[EdmansSinkaMaterial::most_unloadings]{};
  Real alpha[EdmansSinkaMaterial::most_unloadings]{};
  Real beta[EdmansSinkaMaterial::most_unloadings]{};
  Real least[EdmansSinkaMaterial::most_unloadings]{}; ///< of d ln S/d ln gamma, S the unloading slope, to the
                                                      ///< next

  [[nodiscard]] PLATEN_FUNCTION Loading<Real> loading(const Real& gamma) const {
    const Real x = gamma * pair.x_per_gamma;
    const auto point = curve.at(x);
    const bool inside = x < Real(EdmansSinkaCurve<Real>::x_end);
    return {force_scale * point.F_bar, force_scale * pair.x_per_gamma * point.slope,
            pair.R_e * a_bar(inside ? x : Real(EdmansSinkaCurve<Real>::x_end)),
            curve.steepest_log_slope(x, steepest_in_corner), inside ? radius_log_slope : Real(0)};
  }

  /// Over R_e.
  [[nodiscard]] PLATEN_FUNCTION Real a_bar(const Real& x) const {
    if (radius.points > 0) return radius.a_bar(x);
    return RadiusPolynomial<Real>{Real(edmans_sinka_radius.D1), Real(edmans_sinka_radius.D3),
                                  Real(edmans_sinka_radius.D5)}
        .a_bar(x);
  }

  [[nodiscard]] std::vector<double> kinks() const {
    std::vector<double> list;
    for (const double x : curve.kinks()) list.push_back(x / pair.x_per_gamma);
    for (const double x : radius.kinks()) list.push_back(x / pair.x_per_gamma);
    for (int i = 0; i < unloadings; ++i) list.push_back(unload_x[i] / pair.x_per_gamma);
    return list;
  }
  [[nodiscard]] Real gamma_end() const { return Real(EdmansSinkaCurve<Real>::x_end) / pair.x_per_gamma; }

  [[nodiscard]] PLATEN_HOT bool in_range(const Real& gamma) const {
    return gamma * pair.x_per_gamma <= x_valid;
  }

  [[nodiscard]] PLATEN_FUNCTION Real work(const Real& gamma) const {
    return force_scale / pair.x_per_gamma * curve.work(gamma * pair.x_per_gamma);
  }

  [[nodiscard]] PLATEN_FUNCTION Unloading<Real> unloading(const Real& gamma,
                                                          const Loading<Real>& peak) const {
    if (unloadings > 0) return measured_unloading(gamma, peak);
    return unloading_from_slope(gamma, peak, pair.unloading_slope(peak.a) * gamma, Real(1.5));
  }

  [[nodiscard]] PLATEN_FUNCTION Unloading<Real> measured_unloading(const Real& gamma,
                                                                   const Loading<Real>& peak) const {
    using std::cbrt;
    const Real x = gamma * pair.x_per_gamma;
    int i = 0;
    while (i + 2 < unloadings && unload_x[i + 1] < x) ++i;
    Real al = alpha[0], be = beta[0];
    Loading<Real> top = peak;
    if (unloadings > 1) {
      const Real t = larger(Real(0), smaller(Real(1), (x - unload_x[i]) / (unload_x[i + 1] - unload_x[i])));
      al = alpha[i] + t * (alpha[i + 1] - alpha[i]);
      be = beta[i] + t * (beta[i + 1] - beta[i]);
      top.least_a = smaller(top.least_a, least[i]);
    }
    // (10), (12): the overlap at which Hertz carries this force; (11): beta = that over gamma_max - gamma_0
    const Real q = Real(0.75) * peak.F / pair.E_star;
    const Real gamma_hertz = cbrt(q * q * pair.A);
    return unloading_from_slope(gamma, top, al * be * gamma / gamma_hertz * peak.F, al);
  }
};

namespace detail {

inline void check(const EdmansSinkaMaterial& m) {
  constexpr auto name = "edmans-sinka";
  require(name, "sigma_ref_Pa", m.sigma_ref, positive);
  require(name, "E_Pa", m.E, positive);
  require(name, "nu", m.nu, poisson);
  require(name, "k", m.k, positive);
  require(name, "delta_t", m.delta_t, {0, 1, true, false});
  require(name, "a", m.a, {0, 50, true, false}); // exp(50) is past any stress
  // The rounding cubic rises everywhere while its end slopes stay below three times its secant
  // (Fritsch-Carlson), which holds for a delta_t corner <= 0.85.
  const bool rounded = m.variant == EdmansSinkaVariant::c1;
  require(name, "corner", m.corner, {0, rounded ? smaller(1.0, 0.85 / (m.a * m.delta_t)) : 1.0, true, true});
  require(name, "number of radius_delta_bar", m.radii, {0, EdmansSinkaMaterial::most_radii});
  for (int i = 0; i < m.radii; ++i) {
    require(name, "radius_delta_bar", m.radius_delta_bar[i],
            {i > 0 ? m.radius_delta_bar[i - 1] : 0, infinity, true, true});
    require(name, "a_bar", m.a_bar[i], {i > 0 ? m.a_bar[i - 1] : 0, infinity, i == 0, true});
  }
  require(name, "unloadings", m.unloadings, {0, EdmansSinkaMaterial::most_unloadings});
  for (int i = 0; i < m.unloadings; ++i) {
    require(name, "unload_delta_bar", m.unload_delta_bar[i],
            {i > 0 ? m.unload_delta_bar[i - 1] : 0, infinity, true, true});
    require(name, "alpha", m.alpha[i], {1, 10});
    require(name, "beta", m.beta[i], positive);
  }
}

inline auto strength(const EdmansSinkaMaterial& m) {
  return std::make_tuple(m.sigma_ref * m.k * m.delta_t, m.sigma_ref, m.k, m.a, m.corner, m.variant);
}

/// A straight beginning is above Hertz's force for a while. Parameters that never come down to it are of no
/// material. Pressed elastic spheres (pool elastic) carry 1.25 times Hertz's force at x = 0.1.
inline void bound_by_elasticity(EdmansSinka<double>& law) {
  const auto force = [&](double gamma) { return law.loading(gamma).F / 1.5; };
  if (below_hertz_from(law.pair, 0.1 / law.pair.x_per_gamma, force) == infinity) law.x_valid = 0;
}

} // namespace detail

/// Two bodies of radii R1 and R2. Unlike materials: the softer side's loading curve, both sides' elasticity.
inline EdmansSinka<double> prepare(const EdmansSinkaMaterial& m1, double R1, const EdmansSinkaMaterial& m2,
                                   double R2) {
  detail::check(m1);
  detail::check(m2);
  require("edmans-sinka", "radius_m", R1, radius_or_plane);
  require("edmans-sinka", "radius2_m", R2, radius_or_plane);
  const auto strength1 = detail::strength(m1), strength2 = detail::strength(m2);
  const EdmansSinkaMaterial& soft = strength1 <= strength2 ? m1 : m2;
  EdmansSinka<double> law;
  law.pair = make_pair(sphere(R1, m1.E, m1.nu), sphere(R2, m2.E, m2.nu)); // R = infinity is a plane
  law.curve = {soft.k, soft.delta_t, soft.a, soft.corner, soft.variant};
  law.steepest_in_corner = law.curve.steepest_in_corner();
  law.unloadings = soft.unloadings;
  law.radius = {soft.radius_delta_bar, soft.a_bar, soft.radii};
  law.radius_log_slope = soft.radii > 0
                             ? law.radius.least_log_slope()
                             : edmans_sinka_radius.least_log_slope(EdmansSinkaCurve<double>::x_end);
  law.x_valid = flattened_to(law.x_valid, law.pair, std::get<0>(strength1), std::get<0>(strength2));
  law.force_scale = std::numbers::pi * law.pair.R_e * law.pair.R_e * soft.sigma_ref;
  law.gamma_limit = 1000 / law.pair.x_per_gamma;
  detail::bound_by_elasticity(law);
  for (int i = 0; i < soft.unloadings; ++i) {
    law.unload_x[i] = soft.unload_delta_bar[i];
    law.alpha[i] = soft.alpha[i];
    law.beta[i] = soft.beta[i];
  }
  // S goes with alpha beta gamma F^(1/3), and F at least with gamma. An exponent that grows by itself lets
  // more work come back, as a slope that falls: it counts with it.
  for (int i = 0; i + 1 < law.unloadings; ++i) {
    const double per_x = law.unload_x[i + 1] / (law.unload_x[i + 1] - law.unload_x[i]);
    const double falls =
        smaller(0.0, 1 - law.beta[i] / law.beta[i + 1]) + smaller(0.0, 1 - law.alpha[i] / law.alpha[i + 1]);
    const double grows = larger(0.0, law.alpha[i + 1] - law.alpha[i]) / (law.alpha[i] * (1 + law.alpha[i]));
    law.least[i] = smaller(i ? law.least[i - 1] : 4.0 / 3, 4.0 / 3 + per_x * (falls - grows));
  }
  return law;
}

/// Two equal spheres.
inline EdmansSinka<double> prepare(const EdmansSinkaMaterial& m, double R) { return prepare(m, R, m, R); }

/// A sphere against a rigid plane.
inline EdmansSinka<double> prepare_on_rigid_plane(const EdmansSinkaMaterial& m, double R) {
  EdmansSinka<double> law = prepare(m, R);
  law.pair = make_pair(sphere(R, m.E, m.nu), rigid_plane());
  law.force_scale = std::numbers::pi * law.pair.R_e * law.pair.R_e * m.sigma_ref;
  law.gamma_limit = 1000 / law.pair.x_per_gamma;
  law.gamma_elastic = 0;
  return law;
}

} // namespace platen::law
