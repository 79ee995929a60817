#pragma once
// Elastic, perfectly plastic sphere on a rigid flat, with a hardness that falls as the contact grows. Jackson
// & Green, J. Tribol. 127 (2005) 343. In units of first yield, omega = gamma/gamma_c:
//   gamma_c = (pi C sigma_y/(2 E*))^2/A,   C = 1.295 exp(0.736 nu),   F_c = 4/3 E* gamma_c^(3/2)/sqrt(A)
//   F/F_c = omega^(3/2),   a^2 A/gamma_c = omega                                        to omega_t = 1.9
//   F/F_c = exp(-omega^(5/12)/4) omega^(3/2) + 4 H_G/(C sigma_y) (1 - exp(-omega^(5/9)/25)) omega
//   a^2 A/gamma_c = omega (omega/omega_t)^B,   B = 0.14 exp(23 sigma_y/E')                beyond
//   H_G/sigma_y = 2.84 (1 - exp(-0.82 (a/R)^(-0.7)))
// E' and R are those of the sphere on a rigid flat (rigid_flat.hpp). Seen in one program that states all of
// it and in a second that has all but H_G; H_G again in a summary of the paper, whose own text was not at
// hand. At omega_t the published force jumps: +7.5 % for nu = 0, +0.5 % for 0.3, -3.4 % for 0.5.
//   published  with the jump; where it falls the force is held until it is reached again
//   joined     the lesser of the two forces, which is continuous
// The paper unloads nowhere: generic unloading. Valid to a/R = 0.41, a limit that later papers quote and that
// could not be confirmed; sigma_y/E' up to 0.01 (ours). Past delta/R = 0.75 the curve goes on along its
// tangent.

#include "platen/law/curve_table.hpp"
#include "platen/law/kogut_etsion.hpp"
#include "platen/law/rigid_flat.hpp"

#include <vector>

namespace platen::law {

struct JacksonGreenMaterial {
  double E = 0;       ///< Young's modulus [Pa]
  double nu = 0;      ///< Poisson's ratio, in [0, 0.5)
  double sigma_y = 0; ///< uniaxial yield stress [Pa]; infinity: a rigid side
  JointVariant variant = JointVariant::joined;

  static LawInfo info() {
    return {"jackson-green",
            "elastic, perfectly plastic spheres, hardness falling with the contact radius",
            "Jackson & Green (2005); generic unloading",
            "a/R <= 0.41, sigma_y (1 - nu^2)/E <= 0.01",
            "joined|published",
            {youngs_modulus(), poissons_ratio(), yield_stress()}};
  }
  static JacksonGreenMaterial read(const Reader& p) {
    return {p("E_Pa"), p("nu"), p("sigma_y_Pa"), joint_variant(p)};
  }
};

/// The dimensionless curve: F/F_c and contact radius over that at first yield, against omega.
template <class Real = double> struct JacksonGreenCurve {
  Real C{}, B{};
  Real radius_c{}; ///< contact radius at first yield over R

  static constexpr double omega_t = 1.9;

  [[nodiscard]] PLATEN_FUNCTION Real radius(const Real& omega) const {
    using std::pow, std::sqrt;
    return omega <= Real(omega_t) ? sqrt(omega) : sqrt(omega * pow(omega / Real(omega_t), B));
  }
  [[nodiscard]] PLATEN_FUNCTION Real radius_log_slope(const Real& omega) const {
    return omega <= Real(omega_t) ? Real(0.5) : Real(0.5) + B / Real(2);
  }
  /// H_G/sigma_y and its derivative times omega.
  PLATEN_FUNCTION void hardness(const Real& omega, Real& H, Real& H_log) const {
    using std::exp, std::pow;
    const Real y = Real(0.82) * pow(radius_c * radius(omega), Real(-0.7));
    H = Real(2.84) * (Real(1) - exp(-y));
    H_log = Real(-0.7 * 2.84) * y * exp(-y) * radius_log_slope(omega);
  }
  /// The plastic branch and its derivative.
  PLATEN_FUNCTION void plastic(const Real& omega, Real& F, Real& slope) const {
    using std::exp, std::pow;
    Real H{}, H_log{};
    hardness(omega, H, H_log);
    const Real u = pow(omega, Real(5.0 / 12)) / Real(4), v = pow(omega, Real(5.0 / 9)) / Real(25);
    const Real elastic = exp(-u) * pow(omega, Real(1.5)), g = Real(1) - exp(-v);
    const Real scale = Real(4) * omega / C;
    F = elastic + scale * H * g;
    slope = (elastic * (Real(1.5) - Real(5.0 / 12) * u) +
             scale * (H_log * g + H * (g + Real(5.0 / 9) * v * (Real(1) - g)))) /
            omega;
  }
};

struct JacksonGreen {
  using Scalar = double;
  Pair pair;
  double F_c = 0;     ///< [N]
  double gamma_c = 0; ///< [m]
  double a_c = 0;     ///< [m]
  double gamma_elastic = 0;
  double gamma_limit = 0;
  bool material_in_range = true;
  double omega_valid = 0; ///< a/R = 0.41, less for a dent
  JacksonGreenCurve<double> curve;
  Loading<double> held; ///< published: where the force jumps down, in units of F_c
  double held_to = 0;   ///< and where it is reached again, in omega; the end of the elastic branch if nowhere
  double work_held_to = 0;
  LoadingTable force; ///< F/F_c against omega, from there on
  Loading<double> cap;

  [[nodiscard]] PLATEN_HOT Loading<double> loading(double gamma) const {
    Loading<double> here;
    const double omega = gamma / gamma_c;
    if (gamma <= gamma_elastic) {
      here.F = omega * std::sqrt(omega);
      here.slope = 1.5 * here.F / omega;
      here.steepest = 1.5;
      here.least_a = 0.5;
    } else if (omega < held_to) {
      here = held;
    } else if (omega <= force.x_high()) {
      force.at(omega, here);
    } else {
      here = cap;
      here.F = cap.F + cap.slope * (omega - force.x_high());
    }
    here.a = a_c * curve.radius(smaller(omega, force.x_high()));
    here.F *= F_c;
    here.slope *= F_c / gamma_c;
    return here;
  }

  [[nodiscard]] std::vector<double> kinks() const { return {held_to * gamma_c}; }
  [[nodiscard]] double gamma_end() const { return force.x_high() * gamma_c; }

  [[nodiscard]] PLATEN_HOT bool in_range(double gamma) const {
    return material_in_range && gamma <= omega_valid * gamma_c;
  }

  [[nodiscard]] PLATEN_FUNCTION double work(double gamma) const {
    const double omega = gamma / gamma_c;
    double W = 0;
    if (gamma <= gamma_elastic) W = 0.4 * omega * omega * std::sqrt(omega);
    else if (omega < held_to) W = work_held_to - held.F * (held_to - omega);
    else if (omega <= force.x_high()) W = force.work(omega);
    else {
      const double more = omega - force.x_high();
      W = force.end.work + more * (cap.F + cap.slope * more / 2);
    }
    return F_c * gamma_c * W;
  }

  [[nodiscard]] PLATEN_HOT Unloading<double> unloading(double gamma, const Loading<double>& peak) const {
    if (gamma <= gamma_elastic) return {0, 1.5}; // never followed: elastic
    const double S = pair.unloading_slope(peak.a, 1 - gamma_elastic / gamma);
    return unloading_from_slope(gamma, peak, S * gamma, 1.5);
  }
};

namespace detail {

/// Where the plastic branch falls below Hertz: once, between omega = 0.1 and 100.
inline double jackson_green_crossing(const JacksonGreenCurve<double>& curve) {
  double low = 0.1, high = 100;
  for (int i = 0; i < 100; ++i) {
    const double omega = std::sqrt(low * high);
    double F{}, slope{};
    curve.plastic(omega, F, slope);
    (F > omega * std::sqrt(omega) ? low : high) = omega;
  }
  return high;
}

} // namespace detail

inline JacksonGreen prepare(const JacksonGreenMaterial& m1, double R1, const JacksonGreenMaterial& m2,
                            double R2) {
  constexpr auto name = "jackson-green";
  for (const JacksonGreenMaterial& m : {m1, m2}) {
    require(name, "E_Pa", m.E, {0, infinity, true, false});
    require(name, "nu", m.nu, poisson);
    require(name, "sigma_y_Pa", m.sigma_y, {0, infinity, true, false});
  }
  require(name, "radius_m", R1, radius_or_plane);
  require(name, "radius2_m", R2, radius_or_plane);
  const auto factor = [](const JacksonGreenMaterial& m) { return 1.295 * std::exp(0.736 * m.nu); };
  const JacksonGreenMaterial& soft = factor(m1) * m1.sigma_y <= factor(m2) * m2.sigma_y ? m1 : m2;
  require(name, "sigma_y_Pa of the softer side", soft.sigma_y, positive);

  JacksonGreen law;
  law.pair = make_pair(sphere(R1, m1.E, m1.nu), sphere(R2, m2.E, m2.nu));
  const RigidFlat flat = as_rigid_flat(law.pair);
  const double e_y = soft.sigma_y / flat.E;
  require(name, "sigma_y over E' = E/(1 - nu^2) of a rigid flat's sphere", e_y, {0, 0.05, true, false});
  law.material_in_range = e_y <= 0.01;
  law.curve.C = factor(soft);
  law.curve.B = 0.14 * std::exp(23 * e_y);
  law.curve.radius_c = std::numbers::pi * law.curve.C * e_y / 2;
  const double x_c = law.curve.radius_c * law.curve.radius_c; // delta_c/R
  law.gamma_c = x_c / law.pair.x_per_gamma;
  law.a_c = std::sqrt(law.gamma_c / law.pair.A);
  law.F_c = 4.0 / 3 * law.pair.E_star * law.gamma_c * law.a_c;
  law.gamma_limit = 1000 / law.pair.x_per_gamma;
  const double omega_t = JacksonGreenCurve<double>::omega_t;
  const double omega_end = omega_t * std::pow(0.41 * 0.41 / (x_c * omega_t), 1 / (1 + law.curve.B));
  law.omega_valid =
      flattened_to(omega_end * x_c, law.pair, factor(m1) * m1.sigma_y, factor(m2) * m2.sigma_y) / x_c;

  const bool published = soft.variant == JointVariant::published;
  const double start = published ? omega_t : detail::jackson_green_crossing(law.curve);
  law.held = {std::pow(start, 1.5), 0, 0, 1.5, 0.5};
  law.gamma_elastic = start * law.gamma_c;
  const auto sample = [&](double omega) {
    double F{}, slope{};
    law.curve.plastic(omega, F, slope);
    return TableSample{F, slope, law.curve.radius_log_slope(omega)};
  };
  const double end = larger(0.75 / x_c, 4 * start);
  law.held_to = start;
  if (double high = end; published && sample(start).F < law.held.F) // the force has jumped down
    for (int i = 0; i < 100; ++i) {
      const double middle = std::sqrt(law.held_to * high);
      (sample(middle).F < law.held.F ? law.held_to : high) = middle;
    }
  law.work_held_to = 0.4 * std::pow(start, 2.5) + law.held.F * (law.held_to - start);
  law.force.make(law.held_to, end, {law.work_held_to, 1.5, 0.5}, sample);
  const TableSample last = sample(end);
  law.cap = {last.F, last.slope, 0, law.force.end.steepest, 0};
  return law;
}

inline JacksonGreen prepare(const JacksonGreenMaterial& m, double R) { return prepare(m, R, m, R); }

inline JacksonGreen prepare_on_rigid_plane(const JacksonGreenMaterial& m, double R) {
  JacksonGreenMaterial rigid = m;
  rigid.sigma_y = rigid.E = infinity;
  return prepare(m, R, rigid, infinity);
}

} // namespace platen::law
