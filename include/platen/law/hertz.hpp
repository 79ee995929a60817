#pragma once
// Elastic contact of two spheres, or of a sphere and a plane (Hertz, 1882).
//   F = 4/3 E* gamma^(3/2) / sqrt(A),   a = sqrt(gamma/A),   A = 1/R1 + 1/R2
// A finite sphere is stiffer than the half-spaces of the theory by about 1 + 0.55 sqrt(delta/R) (nu = 0.3;
// Tatara and finite elements agree): the law calls itself in range up to delta/R = 0.01, where that is 5.5 %.

#include "platen/law/contact.hpp"
#include "platen/law/pair.hpp"
#include "platen/law/parameter_reader.hpp"

namespace platen::law {

template <class Real = double> struct Hertz {
  using Scalar = Real;
  BasicPair<Real> pair;
  Real gamma_elastic{}; ///< everywhere: gamma_limit
  Real gamma_limit{};

  static constexpr double x_valid = 0.01;

  [[nodiscard]] PLATEN_HOT Loading<Real> loading(const Real& gamma) const {
    using std::sqrt;
    const Real a = sqrt(gamma / pair.A);
    const Real slope = Real(2) * pair.E_star * a;
    return {gamma * slope / Real(1.5), slope, a, Real(1.5), Real(0.5)};
  }

  [[nodiscard]] PLATEN_HOT bool in_range(const Real& gamma) const {
    return gamma * pair.x_per_gamma <= Real(x_valid);
  }

  [[nodiscard]] PLATEN_FUNCTION Real work(const Real& gamma) const {
    return Real(0.4) * gamma * loading(gamma).F;
  }

  [[nodiscard]] PLATEN_HOT Unloading<Real> unloading(const Real&, const Loading<Real>&) const {
    return {Real(0), Real(1.5)}; // never followed: elastic
  }
};

inline Hertz<double> prepare_hertz(const Body& one, const Body& two) {
  Hertz<double> law;
  law.pair = make_pair(one, two);
  law.gamma_limit = law.gamma_elastic = 1000 / law.pair.x_per_gamma;
  return law;
}

struct HertzMaterial {
  double E = 0;  ///< Young's modulus [Pa]
  double nu = 0; ///< Poisson's ratio, in [0, 0.5)

  static LawInfo info() {
    return {"hertz",           "elastic spheres", "Hertz (1882)",
            "delta/R <= 0.01", "published",       {youngs_modulus(), poissons_ratio()}};
  }
  static HertzMaterial read(const Reader& p) { return {p("E_Pa"), p("nu")}; }
};

inline Hertz<double> prepare(const HertzMaterial& m1, double R1, const HertzMaterial& m2, double R2) {
  return prepare_hertz(sphere(R1, m1.E, m1.nu), sphere(R2, m2.E, m2.nu));
}

inline Hertz<double> prepare_on_rigid_plane(const HertzMaterial& m, double R) {
  return prepare_hertz(sphere(R, m.E, m.nu), rigid_plane());
}

} // namespace platen::law
