#pragma once
// Granular geomaterials, linear Drucker-Prager: one power law in units of first yield. Wang et al. (2018).
//   F/F_y = a (gamma/gamma_y)^b                                  (16)
//   F/F_y = m ((gamma - gamma_res)/gamma_y)^n                    (17), gamma_res from (18)
// gamma and gamma_y are both the whole approach of the centres; the elastic limit is a = m = 1, b = n = 3/2.
// The paper's coefficients mix gamma with the gamma_y of one sphere: a = 2^b a_paper, m = 2^n m_paper
// (wang_table2). F_y and gamma_y are Hertz at the peak pressure of drucker_prager_yield.hpp, for any two
// spheres:
//   F_y = pi^3 p0^3 / (6 E*^2 A^2),   gamma_y = pi^2 p0^2 / (4 E*^2 A)          equal spheres: (12), (13)
// Valid for E 10-30 GPa, nu 0.1-0.3, phi 20-40 deg, sigma_c 5-50 MPa, a/R < 0.02 (3.1, Table 1).

#include "platen/law/contact.hpp"
#include "platen/law/drucker_prager_yield.hpp"
#include "platen/law/pair.hpp"
#include "platen/law/parameter_reader.hpp"

#include <tuple>
#include <vector>

namespace platen::law {

enum class WangVariant : unsigned char {
  generic,   ///< a, b given, or both 0: from Table 2; unloading generic
  fitted,    ///< a, b, m, n given; unloading (17)-(18), stiffened where it would create energy
  published, ///< all four from Table 2, unloading as printed. Creates energy in 54 of the paper's 162
             ///< materials (up to 1.7 times the work put in): then `creates_energy` is set and nothing is in
             ///< range
};

struct WangCoefficients {
  double a, b, m, n;
};

/// Table 2, regression (19), in our convention. Its E is in GPa, phi in degrees, sigma_c in MPa.
inline WangCoefficients wang_table2(double E, double nu, double phi_deg, double sigma_c) {
  const double e = E * 1e-9, c = sigma_c * 1e-6, p = phi_deg;
  const auto f = [&](double C0, double C1, double C2, double C3, double C4, double C5, double C6) {
    return C0 + C1 * e + C2 * nu + C3 * p * p + C4 * p + C5 * c * c + C6 * c;
  };
  const double b = f(1.3087, -8.7130e-4, 4.4259e-2, -7.6019e-5, 6.4120e-3, -3.8951e-5, 3.3763e-3);
  const double n = f(1.2377, -1.2352e-3, 3.6574e-2, -9.5000e-5, 8.0222e-3, -7.9491e-5, 6.2875e-3);
  const double a = f(0.5398, 1.0279e-3, -4.7213e-2, 7.6500e-5, -6.1476e-3, 5.5848e-5, -4.4023e-3);
  const double m = f(2.3104, 9.6205e-3, -2.8768e-1, 9.1244e-4, -7.1235e-2, 6.6345e-4, -4.8732e-2);
  return {std::exp2(b) * a, b, std::exp2(n) * m, n};
}

struct WangMaterial {
  double E = 0;       ///< Young's modulus [Pa]
  double nu = 0;      ///< Poisson's ratio, in [0, 0.5)
  double phi_deg = 0; ///< friction angle of triaxial compression [degree]
  double sigma_c = 0; ///< uniaxial compressive strength [Pa]
  WangVariant variant = WangVariant::generic;
  double a = 0, b = 0; ///< (16) in our convention [-]; both 0: Table 2
  double m = 0, n = 0; ///< (17) in our convention, `fitted` only [-]

  static LawInfo info() {
    return {
        "wang",
        "granular geomaterials, Drucker-Prager",
        "Wang et al. (2018), (8)-(18)",
        "E 10-30 GPa, nu 0.1-0.3, phi 20-40 deg, sigma_c 5-50 MPa where a and b are of Table 2; a/R < 0.02; "
        "the contact radius is ours, provisional",
        "generic|fitted|published",
        {youngs_modulus(),
         poissons_ratio(),
         {"phi_deg", "friction angle", {0, 60, false, true}},
         {"sigma_c_Pa", "uniaxial compressive strength", positive},
         {"a", "(16), both overlaps whole; 0: from Table 2", non_negative, Of::pair, 0},
         {"b", "(16); 0: from Table 2", non_negative, Of::pair, 0},
         {"m", "(17), fitted only", non_negative, Of::pair, 0},
         {"n", "(17), fitted only", non_negative, Of::pair, 0}}};
  }
  static WangMaterial read(const Reader& p) {
    return {p("E_Pa"),
            p("nu"),
            p("phi_deg"),
            p("sigma_c_Pa"),
            p.variant == "fitted"      ? WangVariant::fitted
            : p.variant == "published" ? WangVariant::published
                                       : WangVariant::generic,
            p("a"),
            p("b"),
            p("m"),
            p("n")};
  }
};

template <class Real = double> struct Wang {
  using Scalar = Real;
  BasicPair<Real> pair;
  Real F_y{};      ///< force at first yield on the axis [N]
  Real gamma_y{};  ///< overlap there [m]
  Real F_y_edge{}; ///< force at which the edge yields [N]; below F_y for many materials
  Real a{}, b{}, m{}, n{};
  Real gamma_elastic{}; ///< gamma_y
  Real gamma_limit{};
  Real gamma_valid{}; ///< a/R = 0.02
  bool material_in_range = true;
  bool creates_energy = false;
  WangVariant variant = WangVariant::generic;

  [[nodiscard]] PLATEN_FUNCTION Loading<Real> loading(const Real& gamma) const {
    using std::pow;
    const Real least = variant == WangVariant::generic ? Real(0.5) : (b - Real(1)) / n;
    const Real omega = gamma / gamma_y;
    const Real F = F_y * a * pow(omega, b);
    return {F, b * F / gamma, contact_radius(gamma), b, least};
  }

  /// The paper gives none. Ours, provisional: no finite elements have confirmed it. Of the overlap an elastic
  /// part gamma_e fills the area as in Hertz, a^2 = gamma_e/A, and the rest as if the spheres were cut off
  /// there, a^2 = 2 (gamma - gamma_e)/A, to first order in gamma A. gamma_e is what Hertz needs for the
  /// force, gamma_e ~ F^(2/3) ~ gamma^(2b/3), all of gamma at yield:
  ///   a^2 = gamma/A (2 - (gamma/gamma_y)^(2b/3 - 1)),  gamma > gamma_y, b < 3/2;  else Hertz, a^2 = gamma/A
  /// Hertz in the elastic limit b = 3/2; never more than twice Hertz's area.
  [[nodiscard]] PLATEN_FUNCTION Real contact_radius(const Real& gamma) const {
    using std::pow, std::sqrt;
    const Real hertz = gamma / pair.A;
    if (gamma <= gamma_y || Real(1.5) <= b) return sqrt(hertz);
    return sqrt(hertz * (Real(2) - pow(gamma / gamma_y, b / Real(1.5) - Real(1))));
  }

  [[nodiscard]] std::vector<double> kinks() const { return {gamma_y}; }
  [[nodiscard]] PLATEN_HOT bool in_range(const Real& gamma) const {
    return material_in_range && !creates_energy && gamma <= gamma_valid;
  }

  [[nodiscard]] PLATEN_FUNCTION Real work(const Real& gamma) const {
    return loading(gamma).F * gamma / (Real(1) + b);
  }

  [[nodiscard]] PLATEN_FUNCTION Unloading<Real> unloading(const Real& gamma,
                                                          const Loading<Real>& peak) const {
    if (gamma < gamma_y) return {Real(0), Real(1.5)}; // never followed: elastic
    const Real alpha = variant == WangVariant::generic ? Real(1.5) : n;
    const Real S = unloading_slope(gamma, peak);
    if (variant == WangVariant::published) return {S / (n * peak.F), n};
    return unloading_from_slope(gamma, peak, S * gamma, alpha);
  }

  /// Generic, or that of (17) and (18): n F_max/(gamma_max - gamma_res).
  [[nodiscard]] PLATEN_FUNCTION Real unloading_slope(const Real& gamma, const Loading<Real>& peak) const {
    using std::pow;
    if (variant == WangVariant::generic) return pair.unloading_slope(peak.a, Real(1) - gamma_y / gamma);
    return n * peak.F / (gamma_y * pow(peak.F / (m * F_y), Real(1) / n));
  }
};

namespace detail {

inline Wang<double> prepare_wang(const WangMaterial& m1, const Body& one, const WangMaterial& m2,
                                 const Body& two) {
  for (const WangMaterial& m : {m1, m2}) {
    require("wang", "E_Pa", m.E, positive);
    require("wang", "nu", m.nu, poisson);
  }
  const DruckerPragerYield y1 = drucker_prager_yield(m1.nu, m1.phi_deg, m1.sigma_c);
  const DruckerPragerYield y2 = drucker_prager_yield(m2.nu, m2.phi_deg, m2.sigma_c);
  const auto key = [](const WangMaterial& m, double p0) {
    return std::make_tuple(p0, m.sigma_c, m.phi_deg, m.E, m.nu, m.a, m.b, m.m, m.n);
  };
  const bool first = key(m1, y1.p0) <= key(m2, y2.p0);
  const WangMaterial& soft = first ? m1 : m2; // its pressure is reached first
  const DruckerPragerYield& y = first ? y1 : y2;

  Wang<double> law;
  law.pair = make_pair(one, two);
  law.variant = soft.variant;
  const auto hertz_force = [&](double p0) {
    return std::pow(std::numbers::pi * p0, 3) /
           (6 * law.pair.E_star * law.pair.E_star * law.pair.A * law.pair.A);
  };
  law.F_y = hertz_force(y.p0);
  law.F_y_edge = hertz_force(smaller(y1.p0_edge, y2.p0_edge));
  law.gamma_y = std::pow(std::numbers::pi * y.p0 / (2 * law.pair.E_star), 2) / law.pair.A;
  const WangCoefficients table = wang_table2(soft.E, soft.nu, soft.phi_deg, soft.sigma_c);
  const bool from_table = soft.variant == WangVariant::published ||
                          (soft.variant == WangVariant::generic && soft.a == 0 && soft.b == 0);
  law.a = from_table ? table.a : soft.a;
  law.b = from_table ? table.b : soft.b;
  law.m = soft.variant == WangVariant::published ? table.m : soft.m;
  law.n = soft.variant == WangVariant::published ? table.n : soft.n;
  if (from_table && !(law.a > 0 && law.b >= 1 && law.b <= 3))
    throw BadParameter(
        "wang: Table 2 has no law for this rock (a = " + text(law.a) + ", b = " + text(law.b) +
        "); it holds for E 10-30 GPa, nu 0.1-0.3, phi 20-40 deg, sigma_c 5-50 MPa; give a and b");
  require("wang", "a", law.a, positive);
  require("wang", "b", law.b, {1, 3});
  if (soft.variant != WangVariant::generic) {
    require("wang", "m", law.m, positive);
    require("wang", "n", law.n, {1, 3});
  }
  law.gamma_elastic = law.gamma_y;
  law.gamma_limit = 1000 / law.pair.x_per_gamma;
  const auto inside = [](double v, double least, double most) { return v >= least && v <= most; };
  if (from_table)
    for (const WangMaterial& m : {m1, m2})
      law.material_in_range = law.material_in_range && inside(m.E, 10e9, 30e9) && inside(m.nu, 0.1, 0.3) &&
                              inside(m.phi_deg, 20, 40) && inside(m.sigma_c, 5e6, 50e6);
  law.gamma_valid = law.pair.A * 4e-4 * law.pair.R_e * law.pair.R_e;
  for (int i = 0; i < 4; ++i) // the radius law inverted: a few fixed-point steps, it is nearly Hertz
    law.gamma_valid *= std::pow(0.02 * law.pair.R_e / law.contact_radius(law.gamma_valid), 2);
  if (law.variant == WangVariant::published)
    // Work returned over work put in grows or falls with gamma throughout, as gamma^(b/n - 1): the ends
    // decide.
    for (const double gamma : {law.gamma_y, larger(law.gamma_y, law.gamma_valid)}) {
      const Loading<double> at = law.loading(gamma);
      const Unloading<double> end{law.unloading_slope(gamma, at) / (law.n * at.F), law.n};
      const double work = law.work(gamma);
      law.creates_energy |=
          dissipated_work(gamma, Peak<double>{at.F, at.slope, at.a, end, work}) < 1e-9 * work;
    }
  return law;
}

} // namespace detail

inline Wang<double> prepare(const WangMaterial& m1, double R1, const WangMaterial& m2, double R2) {
  require("wang", "radius_m", R1, radius_or_plane);
  require("wang", "radius2_m", R2, radius_or_plane);
  return detail::prepare_wang(m1, sphere(R1, m1.E, m1.nu), m2, sphere(R2, m2.E, m2.nu));
}

inline Wang<double> prepare(const WangMaterial& m, double R) { return prepare(m, R, m, R); }

inline Wang<double> prepare_on_rigid_plane(const WangMaterial& m, double R) {
  require("wang", "radius_m", R, radius_or_plane);
  return detail::prepare_wang(m, sphere(R, m.E, m.nu), m, rigid_plane());
}

} // namespace platen::law
