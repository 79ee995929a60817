#pragma once
// Edinburgh elasto-plastic law, without adhesion (k_adh = 0, f_0 = 0): Thakur et al., Granul. Matter 16
// (2014) 383, as nonlinear springs:
//   F = k_1 gamma^n                           loading
//   F = k_2 (gamma^n - gamma_p^n)             below gamma_max, not below 0
//   k_2 = k_1/(1 - lambda_p),   gamma_p^n = lambda_p gamma_max^n,   k_1 = 4/3 E* R*^(2-n),   R* = 1/A
// n = 3/2 loads like Hertz, n = 1 like luding.hpp with a constant k_2. There is no yield point: lambda_p, n
// and usually E are calibrated. The force law was seen in a summary of the paper and in LAMMPS's
// documentation; k_1 with R* is not in the paper but in later forms of the law, LAMMPS's among them. The
// contact radius, which neither gives, is a^2 = gamma/A while in touch.

#include "platen/law/contact.hpp"
#include "platen/law/pair.hpp"
#include "platen/law/parameter_reader.hpp"

namespace platen::law {

struct EepaMaterial {
  double E = 0;        ///< Young's modulus; sets k_1 [Pa]
  double nu = 0;       ///< Poisson's ratio, in [0, 0.5)
  double lambda_p = 0; ///< contact plasticity 1 - k_1/k_2, in [0, 1)
  double n = 1.5;      ///< exponent, in [1, 2]

  static LawInfo info() {
    return {"eepa",
            "springs of overlap^n with hysteresis, calibrated",
            "Thakur et al. (2014), without adhesion; k_1 as in LAMMPS",
            "as calibrated",
            "published",
            {youngs_modulus(),
             poissons_ratio(),
             {"lambda_p", "contact plasticity 1 - k_1/k_2", {0, 1, false, true}},
             {"n", "exponent", {1, 2}, Of::pair, 1.5}}};
  }
  static EepaMaterial read(const Reader& p) { return {p("E_Pa"), p("nu"), p("lambda_p"), p("n")}; }
};

template <class Real = double> struct Eepa {
  using Scalar = Real;
  BasicPair<Real> pair;
  Real k_1{};            ///< [N/m^n]
  Real k_2{};            ///< [N/m^n]
  Real n{};              ///< [-]
  Real gamma_p_factor{}; ///< gamma_p/gamma_max [-]
  Real alpha{};          ///< exponent of the power law that returns the same work [-]
  Real gamma_elastic{};  ///< 0; everything where lambda_p = 0
  Real gamma_limit{};
  Real lambda_p{}; ///< [-]

  static constexpr Shape shape = Shape::difference;

  [[nodiscard]] PLATEN_HOT Loading<Real> loading(const Real& gamma) const {
    using std::pow, std::sqrt;
    const Real F = k_1 * pow(gamma, n);
    return {F, n * F / gamma, sqrt(gamma / pair.A), n, Real(0.5)};
  }

  [[nodiscard]] PLATEN_HOT bool in_range(const Real&) const { return true; }

  [[nodiscard]] PLATEN_FUNCTION Real work(const Real& gamma) const {
    return loading(gamma).F * gamma / (n + Real(1));
  }

  [[nodiscard]] PLATEN_HOT Unloading<Real> unloading(const Real& gamma, const Loading<Real>&) const {
    return {Real(1) / (gamma * (Real(1) - gamma_p_factor)), alpha};
  }

  [[nodiscard]] PLATEN_HOT Loading<Real> on_unloading(const Real& gamma, const Real& gamma_max,
                                                      const Peak<Real>& peak) const {
    using std::pow, std::sqrt;
    const Real part = pow(gamma / gamma_max, n);
    const Real F = peak.F * (part - lambda_p) / (Real(1) - lambda_p);
    return {larger(F, Real(0)), peak.F * n * part / ((Real(1) - lambda_p) * gamma), sqrt(gamma / pair.A)};
  }
};

inline Eepa<double> prepare(const EepaMaterial& m1, double R1, const EepaMaterial& m2, double R2) {
  constexpr auto name = "eepa";
  for (const EepaMaterial& m : {m1, m2}) {
    require(name, "E_Pa", m.E, {0, infinity, true, false});
    require(name, "nu", m.nu, poisson);
    require(name, "lambda_p", m.lambda_p, {0, 1, false, true});
    require(name, "n", m.n, {1, 2});
  }
  require(name, "radius_m", R1, radius_or_plane);
  require(name, "radius2_m", R2, radius_or_plane);
  if (m1.lambda_p != m2.lambda_p || m1.n != m2.n)
    throw BadParameter("eepa: both sides must have the same lambda_p and n");
  Eepa<double> law;
  law.pair = make_pair(sphere(R1, m1.E, m1.nu), sphere(R2, m2.E, m2.nu));
  law.n = m1.n;
  law.lambda_p = m1.lambda_p;
  law.k_1 = 4.0 / 3 * law.pair.E_star * std::pow(law.pair.A, m1.n - 2);
  law.k_2 = law.k_1 / (1 - m1.lambda_p);
  law.gamma_p_factor = std::pow(m1.lambda_p, 1 / m1.n);
  // integral of (u^n - lambda_p)/(1 - lambda_p) from gamma_p/gamma_max to 1 is (1 - gamma_p/gamma_max)/(1 +
  // alpha)
  const double g = law.gamma_p_factor, lambda_p = m1.lambda_p;
  const double back = ((1 - g * lambda_p) / (m1.n + 1) - lambda_p * (1 - g)) / (1 - lambda_p);
  law.alpha = (1 - g) / back - 1;
  law.gamma_limit = 1000 / law.pair.x_per_gamma;
  law.gamma_elastic = m1.lambda_p == 0 ? law.gamma_limit : 0;
  return law;
}

inline Eepa<double> prepare(const EepaMaterial& m, double R) { return prepare(m, R, m, R); }

inline Eepa<double> prepare_on_rigid_plane(const EepaMaterial& m, double R) {
  EepaMaterial rigid = m;
  rigid.E = infinity;
  return prepare(m, R, rigid, infinity);
}

} // namespace platen::law
