#pragma once
// Mechanically derived contact of an elastic, perfectly plastic sphere: the pair kernel of Zunker & Kamrin,
// J. Mech. Phys. Solids 183 (2024) 105492 and 105493. On a rigid flat (rigid_flat.hpp), x = delta/R:
//   p_Y = sigma_y (1 + 1.75 exp(-4.4 x))                           mean pressure of the yielding contact
//   F = pi a^2 p_Y,   a^2 = 2 R delta - delta^2 + delta_Y^2 - delta_Y R    from delta_Y on; below it Hertz
//   delta_Y: Hertz's mean pressure reaches p_Y
// Unloading is that of an elliptic indenter of height A and half-width a pressed into springs, and of the
// sphere's centre that gives way:
//   A = 4 p_Y a_max/E'
//   F/F_max = 2/pi (acos(1 - xi) - (1 - xi) sqrt(2 xi - xi^2)),   a = a_max sqrt(2 xi - xi^2)
//   xi = 1 - (delta_max - delta)/(A/2 + delta_R)
//   delta_R = F_max (2 a^2 (nu - 1) - (2 nu - 1) z (s - z))/(2 pi a^2 G s)
//   s = sqrt(a^2 + z^2),   z = R - delta_max + A/2,   all at delta_max
// Read off LAMMPS's documentation and the equations in its source, whose authors are the paper's; the paper
// itself was not at hand. Left out, because it needs what a contact alone does not know: the response of the
// bulk and the growing radius of a confined particle, the penalty against contacts through a neighbour; and
// adhesion. Below yield LAMMPS's ellipse falls short of Hertz by 0.075 x: here it is Hertz, without that
// step. Two unequal spheres go by the equivalent equal pair, where LAMMPS averages the forces of both sides.
// At yield the published curves have oddities. The slope of the loading force rises by a third, from Hertz's
// to twice F/delta, so that the force passes above Hertz's (by 6 % at 2 delta_Y). The unloading curve changes
// from Hertz's to the indenter's, and a tenth of the work is lost at once; from there to 1.08 delta_Y the
// work lost falls as the overlap grows, which creates energy, and to about 3 delta_Y the unloading curve may
// lie above the loading curve, by up to 5 %.
//   published   all of it kept; where 1/(A/2 + delta_R) < pi/(2 delta_max) nothing is in range
//   stiffened   that rate raised to pi/(2 delta_max), which keeps the indenter's curve below every loading
//               curve with d ln F/d ln delta <= 2
// Valid to x = 0.75, where LAMMPS stops; then along the tangent.

#include "platen/law/contact.hpp"
#include "platen/law/parameter_reader.hpp"
#include "platen/law/rigid_flat.hpp"

namespace platen::law {

enum class MdrVariant : unsigned char { stiffened, published };

struct MdrMaterial {
  double E = 0;       ///< Young's modulus [Pa]
  double nu = 0;      ///< Poisson's ratio, in [0, 0.5)
  double sigma_y = 0; ///< uniaxial yield stress [Pa]; infinity: a rigid side
  MdrVariant variant = MdrVariant::stiffened;

  static LawInfo info() {
    return {"mdr",
            "elastic, perfectly plastic spheres, pressure falling with overlap: the pair kernel",
            "Zunker & Kamrin (2024), as in LAMMPS; without bulk response, growing radius, adhesion",
            "delta/R <= 0.75; published: not where it may create energy",
            "stiffened|published",
            {youngs_modulus(), poissons_ratio(), yield_stress()}};
  }
  static MdrMaterial read(const Reader& p) {
    return {p("E_Pa"), p("nu"), p("sigma_y_Pa"),
            p.variant == "published" ? MdrVariant::published : MdrVariant::stiffened};
  }
};

struct Mdr {
  using Scalar = double;
  Pair pair;
  RigidFlat flat;
  double sigma_y = 0, nu = 0; ///< of the softer side
  double c = 0;               ///< (delta_Y^2 - delta_Y R)/R^2
  double gamma_elastic = 0;   ///< [m]
  double gamma_limit = 0;
  MdrVariant variant = MdrVariant::stiffened;

  static constexpr Shape shape = Shape::indenter;
  static constexpr double x_end = 0.75; ///< from here on the tangent
  double x_valid = x_end;
  static constexpr double least_rate = std::numbers::pi / 2; ///< times gamma_max [-]

  [[nodiscard]] PLATEN_FUNCTION double p_Y(double x) const {
    return sigma_y * (1 + 1.75 * std::exp(-4.4 * x));
  }

  [[nodiscard]] PLATEN_HOT Loading<double> loading(double gamma) const {
    if (gamma <= gamma_elastic) {
      const double a = std::sqrt(gamma / pair.A), slope = 2 * pair.E_star * a;
      return {gamma * slope / 1.5, slope, a, 1.5, 0.5};
    }
    const double all = gamma * pair.x_per_gamma, x = smaller(all, double(x_end));
    const double a2 = x * (2 - x) + c, p = p_Y(x), scale = std::numbers::pi * flat.R * flat.R;
    const double slope = scale * ((2 - 2 * x) * p - 4.4 * a2 * (p - sigma_y));
    return {scale * a2 * p + slope * (all - x), slope * pair.x_per_gamma, flat.R * std::sqrt(a2), 2, 0};
  }

  [[nodiscard]] double gamma_end() const { return x_end / pair.x_per_gamma; }

  [[nodiscard]] PLATEN_HOT bool in_range(double gamma) const {
    if (gamma * pair.x_per_gamma > x_valid) return false;
    if (variant == MdrVariant::stiffened || gamma <= gamma_elastic) return true;
    return unloading(gamma, loading(gamma)).rate * gamma >= least_rate;
  }

  /// Integral of a^2 p_Y/(R^2 sigma_y) = (x_Y + 2 (1 - x_Y) u - u^2)(1 + 1.75 exp(-4.4 (x_Y + u))) from u =
  /// 0.
  [[nodiscard]] PLATEN_FUNCTION double work_bar(double x_Y, double u) const {
    constexpr double k = 4.4;
    const auto a2 = [&](double v) { return x_Y + v * (2 * (1 - x_Y) - v); };
    const double plain = u * (x_Y + u * (1 - x_Y - u / 3));
    double falling = 0;
    if (u < 0.1) { // the closed form would cancel; five Gauss points are exact to 1e-13 here
      constexpr double at[3] = {0, 0.5384693101056831, 0.9061798459386640};
      constexpr double weight[3] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
      for (int i = -2; i <= 2; ++i) {
        const double v = u / 2 * (1 + (i < 0 ? -at[-i] : at[i]));
        falling += u / 2 * weight[i < 0 ? -i : i] * a2(v) * std::exp(-k * v);
      }
    } else {
      const auto tail = [&](double v) { return (a2(v) + (2 * (1 - x_Y) - 2 * v - 2 / k) / k) / k; };
      falling = tail(0) - std::exp(-k * u) * tail(u);
    }
    return plain + 1.75 * std::exp(-k * x_Y) * falling;
  }

  [[nodiscard]] PLATEN_FUNCTION double work(double gamma) const {
    if (gamma <= gamma_elastic) return 0.4 * gamma * loading(gamma).F;
    const double x_Y = gamma_elastic * pair.x_per_gamma, x = smaller(gamma * pair.x_per_gamma, double(x_end));
    double W = 0.4 * gamma_elastic * loading(gamma_elastic).F +
               std::numbers::pi * flat.R * flat.R * sigma_y * work_bar(x_Y, x - x_Y) / pair.x_per_gamma;
    const double more = gamma - x_end / pair.x_per_gamma;
    if (more > 0) {
      const Loading<double> end = loading(x_end / pair.x_per_gamma);
      W += more * (end.F + end.slope * more / 2);
    }
    return W;
  }

  /// A/2 + delta_R at x [m]
  [[nodiscard]] PLATEN_FUNCTION double recovered(double x, double a) const {
    const double p = p_Y(x), half_A = 2 * p * a / flat.E;
    const double z = flat.R * (1 - x) + half_A, s = std::sqrt(a * a + z * z);
    const double G = flat.E * (1 - nu) / 2;
    return half_A + p / (2 * G * s) * (2 * a * a * (nu - 1) - (2 * nu - 1) * z * (s - z));
  }

  [[nodiscard]] PLATEN_HOT Unloading<double> unloading(double gamma, const Loading<double>& peak) const {
    if (gamma <= gamma_elastic) return {0, 1.5}; // never followed: elastic
    const double x = smaller(gamma * pair.x_per_gamma, double(x_end));
    const double rate = flat.delta_per_gamma / recovered(x, peak.a);
    const double least = variant == MdrVariant::stiffened ? least_rate / gamma : 0;
    return {larger(rate, least), 0.75 * std::numbers::pi - 1}; // the curve returns 4/(3 pi) F_max/rate
  }

  [[nodiscard]] PLATEN_HOT Loading<double> on_unloading(double gamma, double gamma_max,
                                                        const Peak<double>& peak) const {
    const double xi = 1 - peak.end.rate * (gamma_max - gamma), root = std::sqrt(xi * (2 - xi));
    // acos(1 - xi) - (1 - xi) sqrt(2 xi - xi^2), whose terms cancel for small xi
    const double area = xi < 1e-4 ? 4.0 / 3 * std::sqrt(2 * xi) * xi : std::acos(1 - xi) - (1 - xi) * root;
    return {peak.F * 2 / std::numbers::pi * area, peak.F * 4 / std::numbers::pi * root * peak.end.rate,
            peak.a * root};
  }
};

inline Mdr prepare(const MdrMaterial& m1, double R1, const MdrMaterial& m2, double R2) {
  constexpr auto name = "mdr";
  for (const MdrMaterial& m : {m1, m2}) {
    require(name, "E_Pa", m.E, {0, infinity, true, false});
    require(name, "nu", m.nu, poisson);
    require(name, "sigma_y_Pa", m.sigma_y, {0, infinity, true, false});
  }
  require(name, "radius_m", R1, radius_or_plane);
  require(name, "radius2_m", R2, radius_or_plane);
  const MdrMaterial& soft = m1.sigma_y < m2.sigma_y || (m1.sigma_y == m2.sigma_y && m1.nu <= m2.nu) ? m1 : m2;
  require(name, "sigma_y_Pa of the softer side", soft.sigma_y, positive);
  Mdr law;
  law.pair = make_pair(sphere(R1, m1.E, m1.nu), sphere(R2, m2.E, m2.nu));
  law.flat = as_rigid_flat(law.pair);
  law.sigma_y = soft.sigma_y;
  law.nu = soft.nu;
  law.variant = soft.variant;
  law.gamma_limit = 1000 / law.pair.x_per_gamma;
  law.x_valid = flattened_to(Mdr::x_end, law.pair, m1.sigma_y, m2.sigma_y);
  require(name, "E/((1 - nu^2) sigma_y) of a rigid flat's sphere", law.flat.E / soft.sigma_y,
          {10, infinity, false, true});
  const double hertz = 4 * law.flat.E / (3 * std::numbers::pi); // mean pressure over sqrt(x)
  double low = 0, high = Mdr::x_end;
  for (int i = 0; i < 200; ++i) {
    const double x = 0.5 * (low + high);
    (hertz * std::sqrt(x) < law.p_Y(x) ? low : high) = x;
  }
  law.c = high * (high - 1);
  law.gamma_elastic = high / law.pair.x_per_gamma;
  return law;
}

inline Mdr prepare(const MdrMaterial& m, double R) { return prepare(m, R, m, R); }

inline Mdr prepare_on_rigid_plane(const MdrMaterial& m, double R) {
  MdrMaterial rigid = m;
  rigid.sigma_y = rigid.E = infinity;
  return prepare(m, R, rigid, infinity);
}

} // namespace platen::law
