#pragma once
// Rigid-plastic spheres with power-law hardening to large deformation, alone, in a die or under hydrostatic
// loading: the law of chapter 3 of Shahin's thesis for two bodies of any size. Formulas, validity and errata:
// shahin_curve.hpp. Dissimilar sides (docs/explanation/dissimilar-spheres.md):
//   F = pi R_e^2 kappa_e F_bar(x; 1/m),  kappa_e = kappa_bar (A R_e)^(1/m),  kappa_bar of similarity.hpp
// E and nu serve unloading only. The thesis presses with unstated elasticity, "rigid": use E/kappa >= 1000 to
// compare with it. Before the cell is full, where (3.58) diverges, the tangent takes over.

#include "platen/law/curve_table.hpp"
#include "platen/law/pair.hpp"
#include "platen/law/parameter_reader.hpp"
#include "platen/law/shahin_curve.hpp"
#include "platen/law/similarity.hpp"

#include <vector>

namespace platen::law {

struct ShahinMaterial {
  double E = 0;         ///< Young's modulus, for unloading [Pa]
  double nu = 0;        ///< Poisson's ratio, in [0, 0.5)
  double kappa = 0;     ///< strength coefficient [Pa]
  double inverse_m = 0; ///< hardening exponent 1/m, in [0, 1]; the same on both sides
  LoadingCase loading = LoadingCase::simple;
  ShahinVariant variant = ShahinVariant::published;
  ShahinCoefficients<double> coefficients = {}; ///< 0: published; the same on both sides

  static LawInfo info() {
    return {
        "shahin",
        "rigid-plastic spheres with power-law hardening, large deformation",
        "Shahin's thesis, (3.45)-(3.59)",
        "0 <= 1/m <= 1; force below Hertz's; delta/R <= 0.5, in a cell until it is full",
        "published|hardening-minimum",
        with_coefficients({youngs_modulus(), poissons_ratio(), strength_coefficient(), hardening_exponent()},
                          shahin_coefficients),
        {loading_case()}};
  }
  static ShahinMaterial read(const Reader& p) {
    ShahinMaterial m{p("E_Pa"), p("nu"), p("kappa_Pa"), p("inverse_m"), p.loading()};
    m.variant = p.variant == "published" ? ShahinVariant::published : ShahinVariant::hardening_minimum;
    for (const auto& c : shahin_coefficients) m.coefficients.*c.member = p(c.key);
    return m;
  }
};

struct Shahin {
  using Scalar = double;
  Pair pair;
  double force_scale = 0;   ///< pi R_e^2 kappa_e [N]
  double gamma_elastic = 0; ///< 0: rigid-plastic
  double gamma_limit = 0;
  ShahinCurve<double> curve; ///< exact; the tables follow it to 1e-4
  double x_valid = 0.5;
  double x_elastic = 0;          ///< below, the force is above Hertz's
  double x_cap = 0.6;            ///< from here on the tangent
  double first_log_slope = 1.25; ///< below the table: a power of x
  Loading<double> first;         ///< F_bar at the start of the table
  LoadingTable plastic;
  ClosureTable closure;
  Loading<double> cap;
  CurveHistory at_cap;
  SlopeTable slopes; ///< from x_table to x_cap
  double slope_at_cap = 0;

  static constexpr double x_table = 0x1p-24; ///< the table starts here
  static constexpr double X_end = 0.9995;    ///< how far towards the full cell (3.58) is followed

  /// F_bar, dF_bar/dx and the history, all but the radius.
  PLATEN_HOT void force(double x, Loading<double>& here) const {
    if (x < plastic.x_low()) return outside(x, here);
    if (x <= plastic.x_high()) return plastic.at(x, here);
    if (x <= closure.x_high) return closure.at(x, here);
    outside(x, here);
  }

  /// Before the tables and after them.
  PLATEN_RARE void outside(double x, Loading<double>& here) const {
    if (x < plastic.x_low()) {
      here.F = first.F * std::pow(x / plastic.x_low(), first_log_slope);
      here.slope = first_log_slope * here.F / x;
      here.steepest = first_log_slope;
      here.least_a = 0.5;
      return;
    }
    here.F = cap.F + cap.slope * (x - x_cap);
    here.slope = cap.slope;
    here.steepest = at_cap.steepest;
    here.least_a = 0; // the radius is held
  }

  [[nodiscard]] PLATEN_HOT Loading<double> loading(double gamma) const {
    const double x = gamma * pair.x_per_gamma;
    Loading<double> here;
    force(x, here);
    here.F *= force_scale;
    here.slope *= force_scale * pair.x_per_gamma;
    here.a = pair.R_e * curve.radius.a_bar(x < x_cap ? x : x_cap);
    return here;
  }

  [[nodiscard]] std::vector<double> kinks() const { return {curve.x_min / pair.x_per_gamma}; }
  [[nodiscard]] double gamma_end() const { return x_cap / pair.x_per_gamma; }

  [[nodiscard]] PLATEN_HOT bool in_range(double gamma) const {
    const double x = gamma * pair.x_per_gamma;
    return x_elastic <= x && x <= x_valid;
  }

  /// Work up to x.
  [[nodiscard]] PLATEN_FUNCTION double work_bar(double x) const {
    if (x < plastic.x_low()) {
      Loading<double> here;
      outside(x, here);
      return here.F * x / (1 + first_log_slope);
    }
    if (x <= plastic.x_high()) return plastic.work(x);
    if (x <= x_cap) return closure.work(x);
    return at_cap.work + (x - x_cap) * (cap.F + cap.slope * (x - x_cap) / 2);
  }

  [[nodiscard]] PLATEN_FUNCTION double work(double gamma) const {
    return force_scale / pair.x_per_gamma * work_bar(gamma * pair.x_per_gamma);
  }

  [[nodiscard]] PLATEN_HOT Unloading<double> unloading(double gamma, const Loading<double>& peak) const {
    const double x = gamma * pair.x_per_gamma;
    if (x < plastic.x_low())
      return unloading_from_slope(gamma, peak, pair.unloading_slope(peak.a) * gamma, 1.5);
    const double S_gamma = x < x_cap ? slopes.value(x) : slope_at_cap * x;
    return unloading_from_slope(gamma, peak, S_gamma, 1.5);
  }
};

namespace detail {

inline Shahin prepare_shahin(const ShahinMaterial& m1, const Body& one, const ShahinMaterial& m2,
                             const Body& two) {
  constexpr auto name = "shahin";
  for (const ShahinMaterial& m : {m1, m2}) {
    require(name, "E_Pa", m.E, {0, infinity, true, false});
    require(name, "nu", m.nu, poisson);
    require(name, "kappa_Pa", m.kappa, {0, infinity, true, false}); // infinity: a rigid side
    require(name, "inverse_m", m.inverse_m, {0, 1});
    if (m.kappa < infinity) require_softer_than_elastic(name, m.kappa, m.E);
  }
  if (m1.loading != m2.loading || m1.variant != m2.variant || m1.inverse_m != m2.inverse_m)
    throw BadParameter("shahin: both sides must have the same inverse_m, loading and variant");
  const double kappa_bar = similarity_strength(m1.kappa, m2.kappa, m1.inverse_m);
  require(name, "kappa_Pa of the softer side", kappa_bar, positive);

  Shahin law;
  law.pair = make_pair(one, two);
  law.force_scale =
      std::numbers::pi * law.pair.R_e * law.pair.R_e * kappa_bar * std::pow(law.pair.sharing(), m1.inverse_m);
  const auto coefficients = with_given(
      name, shahin_coefficients, ShahinCoefficients<double>::published(m1.loading, m1.inverse_m, m1.variant),
      m1.coefficients);
  law.curve = ShahinCurve<double>::make(m1.loading, m1.inverse_m, coefficients);
  law.gamma_limit = 1000 / law.pair.x_per_gamma;
  const ShahinCurve<double>& curve = law.curve;
  const auto sample = [&](double x) {
    const auto point = curve.at(x);
    return TableSample{point.F, point.slope, point.a_log_slope};
  };
  const auto first = curve.at(Shahin::x_table);
  law.first = {first.F, first.slope, first.a};
  law.first_log_slope = Shahin::x_table * first.slope / first.F;
  const CurveHistory start{first.F * Shahin::x_table / (1 + law.first_log_slope), law.first_log_slope, 0.5};
  if (m1.loading == LoadingCase::simple) {
    law.plastic.make(Shahin::x_table, law.x_cap, start, sample);
    law.at_cap = law.plastic.end;
  } else {
    law.plastic.make(Shahin::x_table, curve.x_min, start, sample);
    law.closure.make(m1.loading, curve.chi_min, 1.0, 1.0, Shahin::X_end, law.plastic.end, sample);
    law.at_cap = law.closure.end;
    law.x_valid = law.x_cap = law.closure.x_high;
  }
  law.x_valid = flattened_to(law.x_valid, law.pair, m1.kappa, m2.kappa);
  require_rising(name, curve, Shahin::x_table, law.x_cap);
  const auto end = curve.at(law.x_cap);
  law.cap = {end.F, end.slope, end.a};
  const auto slope = [&](double x) {
    return law.pair.unloading_slope(law.pair.R_e * curve.radius.a_bar(x)) / law.pair.x_per_gamma * x;
  };
  law.slopes.make(Shahin::x_table, law.x_cap, slope);
  law.slope_at_cap = slope(law.x_cap) / law.x_cap;
  law.x_elastic = below_hertz_from(law.pair, law.x_valid / law.pair.x_per_gamma,
                                   [&](double gamma) { return law.loading(gamma).F; }) *
                  law.pair.x_per_gamma;
  return law;
}

} // namespace detail

inline Shahin prepare(const ShahinMaterial& m1, double R1, const ShahinMaterial& m2, double R2) {
  require("shahin", "radius_m", R1, radius_or_plane);
  require("shahin", "radius2_m", R2, radius_or_plane);
  return detail::prepare_shahin(m1, sphere(R1, m1.E, m1.nu), m2, sphere(R2, m2.E, m2.nu));
}

inline Shahin prepare(const ShahinMaterial& m, double R) { return prepare(m, R, m, R); }

inline Shahin prepare_on_rigid_plane(const ShahinMaterial& m, double R) {
  ShahinMaterial rigid = m;
  rigid.kappa = rigid.E = infinity;
  return prepare(m, R, rigid, infinity);
}

} // namespace platen::law
