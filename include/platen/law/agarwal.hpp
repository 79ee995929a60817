#pragma once
// Elastic, perfectly plastic spheres to large deformation, alone, in a die or under hydrostatic loading: the
// law of chapter 2 of Shahin's thesis (Agarwal, Shahin & Gonzalez) for two bodies of any size. Formulas,
// validity and errata: agarwal_curve.hpp. Dissimilar sides (docs/explanation/dissimilar-spheres.md):
//   F = pi R_e^2 sigma_soft F_bar(x; lambda_e),  lambda_e = E* A R_e/sigma_soft,  zeta of the softer side
// The confined cases are cells of equal particles; with dissimilar ones they are an extrapolation.
//
// Past the validity the curve goes on along its formula for a fifth, then along its tangent.

#include "platen/law/agarwal_curve.hpp"
#include "platen/law/curve_table.hpp"
#include "platen/law/pair.hpp"
#include "platen/law/parameter_reader.hpp"

#include <tuple>
#include <vector>

namespace platen::law {

struct AgarwalMaterial {
  double E = 0;       ///< Young's modulus [Pa]
  double nu = 0;      ///< Poisson's ratio, in [0, 0.5)
  double sigma_y = 0; ///< uniaxial yield stress [Pa]
  LoadingCase loading = LoadingCase::simple;
  AgarwalVariant variant = AgarwalVariant::hertz_radius; ///< the same on both sides
  AgarwalCoefficients<double> coefficients = {};         ///< 0: published; of the softer side

  static LawInfo info() {
    return {"agarwal",
            "elastic, perfectly plastic spheres, large deformation",
            "Agarwal, Shahin & Gonzalez: Shahin's thesis, (2.12)-(2.48)",
            "lambda = E/((1 - nu^2) sigma_y) 117-5933 (formally >= 22.1); delta/R <= 0.5, in a cell a little "
            "past full",
            "hertz-radius|published",
            with_coefficients({youngs_modulus(), poissons_ratio(), yield_stress()}, agarwal_coefficients),
            {loading_case(),
             {"kind", "secondary: the sides of a particle in a die; refused, see docs/laws/agarwal.md",
              "primary|secondary"}}};
  }
  static AgarwalMaterial read(const Reader& p) {
    if (p.word("kind") == "secondary")
      throw BadParameter(
          "agarwal: kind = secondary is no law of its own overlap: the thesis gives the sides of a particle "
          "in a die "
          "over the overlap of the primary contacts, force up to x = gamma/2R = 0.1 and pressure from about "
          "0.41 on, "
          "nothing between and no unloading; allowed here is primary (C++: secondary_contact() in "
          "agarwal_secondary.hpp)");
    AgarwalMaterial m{p("E_Pa"), p("nu"), p("sigma_y_Pa"), p.loading()};
    m.variant = p.variant == "published" ? AgarwalVariant::published : AgarwalVariant::hertz_radius;
    for (const auto& c : agarwal_coefficients) m.coefficients.*c.member = p(c.key);
    return m;
  }
};

struct Agarwal {
  using Scalar = double;
  Pair pair;
  double force_scale = 0;   ///< pi R_e^2 sigma_soft [N]
  double gamma_elastic = 0; ///< (2.17) [m]
  double gamma_limit = 0;   ///< [m]
  bool material_in_range = true;
  AgarwalCurve<double> curve; ///< exact; the tables follow it to 1e-4
  double x_first = 0;         ///< the published force is unreliable below 0.05
  double x_valid = 0.5;
  double x_cap = 0.6;   ///< from here on the tangent
  LoadingTable plastic; ///< x_y to x_min, or to x_cap in simple loading
  ClosureTable closure;
  Loading<double> cap; ///< F_bar, dF_bar/dx and a_bar at x_cap
  CurveHistory at_cap;
  SlopeTable slopes; ///< from x_y to x_cap
  LogTable<3> radii; ///< a_bar, from x_y to x_cap: 1e-5 of (2.13)
  double slope_at_cap = 0;

  /// F_bar, dF_bar/dx and the history, all but the radius.
  PLATEN_HOT void force(double x, Loading<double>& here) const {
    if (x < plastic.x_low()) return outside(x, here);
    if (x <= plastic.x_high()) return plastic.at(x, here);
    if (x <= closure.x_high) return closure.at(x, here);
    outside(x, here);
  }

  /// The regimes that are cheap or rare: elastic, elastic volumetric, and the tangent.
  PLATEN_RARE void outside(double x, Loading<double>& here) const {
    if (x_cap < x) {
      here.F = cap.F + cap.slope * (x - x_cap);
      here.slope = cap.slope;
      here.steepest = at_cap.steepest;
      here.least_a = 0; // the radius is held
      return;
    }
    const auto point = curve.at(x);
    here.F = point.F;
    here.slope = point.slope;
    here.steepest = x <= curve.x_y ? 1.5 : larger(closure.end.steepest, x * point.slope / point.F);
    here.least_a = x <= curve.x_y ? curve.radius.log_slope(x) : at_cap.least_a;
  }

  [[nodiscard]] PLATEN_HOT Loading<double> loading(double gamma) const {
    const double x = gamma * pair.x_per_gamma;
    Loading<double> here;
    if (x <= curve.x_y) { // (2.15), inlined: in a loose packing many contacts are elastic
      const double root = std::sqrt(x);
      const bool hertz = curve.variant == AgarwalVariant::hertz_radius;
      here.a = hertz ? root : curve.radius.a_bar(x);
      here.least_a = hertz ? 0.5 : curve.radius.log_slope(x);
      here.F = 4 / (3 * std::numbers::pi) * curve.lambda * root * here.a * here.a;
      here.slope = here.F * (0.5 + 2 * here.least_a) / x;
      here.steepest = 1.5;
    } else {
      force(x, here);
      here.a = radii.value(x < x_cap ? x : x_cap);
    }
    here.F *= force_scale;
    here.slope *= force_scale * pair.x_per_gamma;
    here.a *= pair.R_e;
    return here;
  }

  [[nodiscard]] std::vector<double> kinks() const {
    std::vector<double> list;
    for (const double x : {curve.x_y, curve.x_h, curve.x_joined, curve.x_min, curve.x_zp})
      list.push_back(x / pair.x_per_gamma);
    return list;
  }
  [[nodiscard]] double gamma_end() const { return x_cap / pair.x_per_gamma; }

  [[nodiscard]] PLATEN_HOT bool in_range(double gamma) const {
    const double x = gamma * pair.x_per_gamma;
    return material_in_range && x >= x_first && x <= x_valid;
  }

  /// Work up to x.
  [[nodiscard]] PLATEN_FUNCTION double work_bar(double x) const {
    if (x <= curve.x_y) return elastic_work(x);
    if (x <= plastic.x_high()) return plastic.work(x);
    if (x <= closure.x_high) return closure.work(x);
    if (x <= x_cap) return closure.end.work + volumetric_work(x);
    return at_cap.work + (x - x_cap) * (cap.F + cap.slope * (x - x_cap) / 2);
  }

  [[nodiscard]] PLATEN_FUNCTION double work(double gamma) const {
    return force_scale / pair.x_per_gamma * work_bar(gamma * pair.x_per_gamma);
  }

  [[nodiscard]] PLATEN_HOT Unloading<double> unloading(double gamma, const Loading<double>& peak) const {
    const double x = gamma * pair.x_per_gamma;
    if (x <= curve.x_y) return {0, 1.5}; // never followed: elastic
    const double S_gamma = x < x_cap ? slopes.value(x) : slope_at_cap * x;
    return unloading_from_slope(gamma, peak, S_gamma, 1.5);
  }

  /// Integral of the elastic F_bar: 4 lambda/(3 pi) sqrt(x) a_bar^2.
  [[nodiscard]] PLATEN_RARE double elastic_work(double x) const {
    const double scale = 4 / (3 * std::numbers::pi) * curve.lambda * x * x * std::sqrt(x);
    if (curve.variant == AgarwalVariant::hertz_radius) return scale / 2.5;
    const double D1 = curve.radius.D1, D3 = curve.radius.D3, D5 = curve.radius.D5;
    return scale * (D1 * D1 / 2.5 +
                    x * (-2 * D1 * D3 / 3.5 +
                         x * ((D3 * D3 + 2 * D1 * D5) / 4.5 + x * (-2 * D3 * D5 / 5.5 + x * D5 * D5 / 6.5))));
  }

  /// From x_zp to x; the integrand is a polynomial of degree 8, which five Gauss points integrate exactly.
  [[nodiscard]] PLATEN_RARE double volumetric_work(double x) const {
    const double point[3] = {0, 0.5384693101056831, 0.9061798459386640};
    const double weight[3] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
    const double half = (x - closure.x_high) / 2, middle = (x + closure.x_high) / 2;
    double sum = weight[0] * curve.F_bar(middle);
    for (int i = 1; i < 3; ++i)
      sum += weight[i] * (curve.F_bar(middle - half * point[i]) + curve.F_bar(middle + half * point[i]));
    return half * sum;
  }
};

namespace detail {

inline Agarwal prepare_agarwal(const AgarwalMaterial& m1, const Body& one, const AgarwalMaterial& m2,
                               const Body& two) {
  constexpr auto name = "agarwal";
  for (const AgarwalMaterial& m : {m1, m2}) {
    require(name, "E_Pa", m.E, positive);
    require(name, "nu", m.nu, poisson);
    require(name, "sigma_y_Pa", m.sigma_y, positive);
  }
  if (m1.loading != m2.loading || m1.variant != m2.variant)
    throw BadParameter("agarwal: both sides must have the same loading and variant");
  const auto key = [](const AgarwalMaterial& m) { return std::make_tuple(m.sigma_y, m.E, m.nu); };
  const AgarwalMaterial& soft = key(m1) <= key(m2) ? m1 : m2;

  Agarwal law;
  law.pair = make_pair(one, two);
  const double lambda = law.pair.E_star * law.pair.sharing() / soft.sigma_y;
  const double zeta = soft.E / (3 * (1 - 2 * soft.nu)) / soft.sigma_y;
  require(name, "lambda = E/((1 - nu^2) sigma_y)", lambda, {22.1, infinity, false, true});
  law.force_scale = std::numbers::pi * law.pair.R_e * law.pair.R_e * soft.sigma_y;
  law.material_in_range = lambda >= 117 && lambda <= 5934; // the simulations of Table A.1
  const auto coefficients =
      with_given(name, agarwal_coefficients,
                 AgarwalCoefficients<double>::published(soft.loading, lambda, zeta), soft.coefficients);
  law.curve = AgarwalCurve<double>::make(soft.loading, soft.variant, lambda, zeta, coefficients);
  const AgarwalCurve<double>& curve = law.curve;
  require(name, "x_joined", curve.x_joined, {curve.x_y, infinity, true, true});
  require(name, "x_h", curve.x_h, {curve.x_y, curve.x_min, true, true});
  require(name, "H_min", curve.H_min, {0, curve.H_max, true, true});
  law.gamma_elastic = curve.x_y / law.pair.x_per_gamma;
  law.gamma_limit = 1000 / law.pair.x_per_gamma;
  law.x_first = soft.variant == AgarwalVariant::published ? 0.05 : 0;

  const auto sample = [&](double x) {
    const auto point = curve.at(x);
    return TableSample{point.F, point.slope, point.a_log_slope};
  };
  const CurveHistory yielded{law.elastic_work(curve.x_y), 1.5, 0.5};
  if (soft.loading == LoadingCase::simple) {
    law.plastic.make(curve.x_y, law.x_cap, yielded, sample);
    law.at_cap = law.plastic.end;
  } else {
    const double x_filled = x_of_filled_cell(soft.loading);
    law.x_valid = 1.03 * x_filled; // "beyond ... by a small margin", 2.3
    law.x_cap = larger(1.2 * x_filled, 1.05 * curve.x_zp);
    law.plastic.make(curve.x_y, curve.x_min, yielded, sample);
    law.closure.make(soft.loading, curve.chi_min, curve.chi_zp, curve.l, 1.0, law.plastic.end, sample);
    law.at_cap = law.closure.end;
    for (int i = 0; i <= 64; ++i) {
      const double x = law.closure.x_high + (law.x_cap - law.closure.x_high) * i / 64;
      law.at_cap.pass(x, sample(x));
    }
    law.at_cap.work += law.volumetric_work(law.x_cap);
  }
  law.x_valid = flattened_to(law.x_valid, law.pair, m1.sigma_y, m2.sigma_y);
  require_rising(name, curve, curve.x_y, law.x_cap);
  const auto end = curve.at(law.x_cap);
  law.cap = {end.F, end.slope, end.a};
  // The finite size of the sphere stiffens the unloading; faded in from yield on, where unloading is Hertz's.
  const auto slope = [&](double x) {
    return law.pair.unloading_slope(law.pair.R_e * curve.at(x).a, 1 - curve.x_y / x) / law.pair.x_per_gamma *
           x;
  };
  law.slopes.make(curve.x_y, law.x_cap, slope);
  law.radii.make(curve.x_y, law.x_cap, [&](double x) { return curve.at(x).a; });
  law.slope_at_cap = slope(law.x_cap) / law.x_cap;
  return law;
}

} // namespace detail

inline Agarwal prepare(const AgarwalMaterial& m1, double R1, const AgarwalMaterial& m2, double R2) {
  require("agarwal", "radius_m", R1, radius_or_plane);
  require("agarwal", "radius2_m", R2, radius_or_plane);
  return detail::prepare_agarwal(m1, sphere(R1, m1.E, m1.nu), m2, sphere(R2, m2.E, m2.nu));
}

inline Agarwal prepare(const AgarwalMaterial& m, double R) { return prepare(m, R, m, R); }

inline Agarwal prepare_on_rigid_plane(const AgarwalMaterial& m, double R) {
  require("agarwal", "radius_m", R, radius_or_plane);
  return detail::prepare_agarwal(m, sphere(R, m.E, m.nu), m, rigid_plane());
}

} // namespace platen::law
