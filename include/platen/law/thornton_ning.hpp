#pragma once
// Elastic, perfectly plastic spheres whose contact pressure is cut off at p_y. Thornton & Ning, Powder
// Technol. 99 (1998) 154, without its adhesion:
//   F = F_y + pi p_y (gamma - gamma_y)/A    from yield on; below it Hertz                              (19)
//   gamma_y = (pi p_y/(2 E*))^2/A,   F_y = 2/3 pi p_y gamma_y/A,   a^2 = gamma/A                 (9), (16)
//   F = 4/3 E* sqrt(R_p) (gamma - gamma_p)^(3/2),   R_p F_max = F_Hertz(gamma_max)/A   unloading (20), (29)
// Loading leaves Hertz with its slope 2 E* a_y. Unloading starts with 2 E* a_max and returns a part of the
// work that never exceeds what was spent. The equations were seen, numbered, in a summary of the paper, and
// the force law again in a second one; (28) follows from (19) and (20) (tested). p_y is a parameter: Hertz
// and von Mises first yield at 1.6 sigma_y, full plasticity means about 2.8 sigma_y. The paper states no
// range; ours is that of Hertz's geometry, delta/R <= 0.01.

#include "platen/law/contact.hpp"
#include "platen/law/pair.hpp"
#include "platen/law/parameter_reader.hpp"

namespace platen::law {

struct ThorntonNingMaterial {
  double E = 0;   ///< Young's modulus [Pa]
  double nu = 0;  ///< Poisson's ratio, in [0, 0.5)
  double p_y = 0; ///< limiting contact pressure [Pa]; infinity: a rigid side

  static LawInfo info() {
    return {"thornton-ning",
            "elastic spheres with a largest contact pressure; a straight line from yield on",
            "Thornton & Ning (1998), without adhesion",
            "delta/R <= 0.01 (ours; the paper states none)",
            "published",
            {youngs_modulus(),
             poissons_ratio(),
             {"p_y_Pa", "largest contact pressure, 1.6 to 2.8 yield stresses", positive, Of::body}}};
  }
  static ThorntonNingMaterial read(const Reader& p) { return {p("E_Pa"), p("nu"), p("p_y_Pa")}; }
};

template <class Real = double> struct ThorntonNing {
  using Scalar = Real;
  BasicPair<Real> pair;
  Real F_y{};           ///< [N]
  Real stiffness{};     ///< pi p_y/A [N/m]
  Real gamma_elastic{}; ///< gamma_y [m]
  Real gamma_limit{};

  static constexpr double x_valid = 0.01;

  [[nodiscard]] PLATEN_HOT Loading<Real> loading(const Real& gamma) const {
    using std::sqrt;
    const Real a = sqrt(gamma / pair.A);
    if (gamma <= gamma_elastic) {
      const Real slope = Real(2) * pair.E_star * a;
      return {gamma * slope / Real(1.5), slope, a, Real(1.5), Real(0.5)};
    }
    return {F_y + stiffness * (gamma - gamma_elastic), stiffness, a, Real(1.5), Real(0.5)};
  }

  [[nodiscard]] PLATEN_HOT bool in_range(const Real& gamma) const {
    return gamma * pair.x_per_gamma <= Real(x_valid);
  }

  [[nodiscard]] PLATEN_FUNCTION Real work(const Real& gamma) const {
    if (gamma <= gamma_elastic) return Real(0.4) * gamma * loading(gamma).F;
    const Real more = gamma - gamma_elastic;
    return Real(0.4) * gamma_elastic * F_y + more * (F_y + stiffness * more / Real(2));
  }

  /// (20) and (29) have 2 E* a_max gamma_max/F_max >= 3/2, which is all that the bounds of
  /// unloading_from_slope ask for here.
  [[nodiscard]] PLATEN_HOT Unloading<Real> unloading(const Real& gamma, const Loading<Real>& peak) const {
    if (gamma <= gamma_elastic) return {Real(0), Real(1.5)}; // never followed: elastic
    return unloading_from_slope(gamma, peak, Real(2) * pair.E_star * peak.a * gamma, Real(1.5));
  }
};

inline ThorntonNing<double> prepare(const ThorntonNingMaterial& m1, double R1, const ThorntonNingMaterial& m2,
                                    double R2) {
  constexpr auto name = "thornton-ning";
  for (const ThorntonNingMaterial& m : {m1, m2}) {
    require(name, "E_Pa", m.E, {0, infinity, true, false});
    require(name, "nu", m.nu, poisson);
    require(name, "p_y_Pa", m.p_y, {0, infinity, true, false});
  }
  require(name, "radius_m", R1, radius_or_plane);
  require(name, "radius2_m", R2, radius_or_plane);
  const double p_y = smaller(m1.p_y, m2.p_y);
  require(name, "p_y_Pa of the softer side", p_y, positive);
  ThorntonNing<double> law;
  law.pair = make_pair(sphere(R1, m1.E, m1.nu), sphere(R2, m2.E, m2.nu));
  law.stiffness = std::numbers::pi * p_y / law.pair.A;
  law.gamma_elastic = std::pow(std::numbers::pi * p_y / (2 * law.pair.E_star), 2) / law.pair.A;
  law.F_y = law.stiffness * law.gamma_elastic / 1.5;
  law.gamma_limit = 1000 / law.pair.x_per_gamma;
  return law;
}

inline ThorntonNing<double> prepare(const ThorntonNingMaterial& m, double R) { return prepare(m, R, m, R); }

inline ThorntonNing<double> prepare_on_rigid_plane(const ThorntonNingMaterial& m, double R) {
  ThorntonNingMaterial rigid = m;
  rigid.p_y = rigid.E = infinity;
  return prepare(m, R, rigid, infinity);
}

} // namespace platen::law
