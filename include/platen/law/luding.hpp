#pragma once
// Linear hysteretic springs, the law of many DEM codes. Luding, Granul. Matter 10 (2008) 235, without
// adhesion (k_c = 0, f_0 = 0): the force is never negative.
//   F = k_1 gamma                                     loading
//   F = k_2 (gamma - gamma_0), not below 0            below gamma_max
//   gamma_0 = (1 - k_1/k_2) gamma_max
//   k_2 = k_1 + (k_2max - k_1) gamma_max/gamma_p      to gamma_p, constant beyond
//   gamma_p = k_2max/(k_2max - k_1) phi_f 2 R1 R2/(R1 + R2)
// Beyond gamma_p the contact has no more plasticity to give: it goes up and down the line of k_2max, as in
// MercuryDPM and YADE.
// The springs are no material's: they are calibrated, and hold for the radius that they were calibrated at.
// The equations were seen in two independent places. The
// contact radius is that of the overlapping spheres' Hertz contact, a^2 = gamma/A, as LAMMPS takes it; the
// paper gives none.

#include "platen/law/contact.hpp"
#include "platen/law/pair.hpp"
#include "platen/law/parameter_reader.hpp"

#include <vector>

namespace platen::law {

struct LudingMaterial {
  double k_1 = 0;   ///< loading stiffness [N/m]
  double k_2 = 0;   ///< largest unloading stiffness, at least k_1 [N/m]
  double phi_f = 0; ///< plasticity depth: gamma_0 at gamma_p over the reduced diameter [-]

  static LawInfo info() {
    return {"luding",
            "linear springs with hysteresis, calibrated",
            "Luding (2008), without adhesion",
            "for the radius it is calibrated at, to the overlap where k_2 is reached",
            "published",
            {{"k_1_N_per_m", "loading stiffness", positive},
             {"k_2_N_per_m", "largest unloading stiffness, at least k_1", positive},
             {"phi_f", "plasticity depth over the reduced diameter", {0, 1, true, false}}}};
  }
  static LudingMaterial read(const Reader& p) { return {p("k_1_N_per_m"), p("k_2_N_per_m"), p("phi_f")}; }
};

template <class Real = double> struct Luding {
  using Scalar = Real;
  BasicPair<Real> pair; ///< geometry alone
  Real k_1{}, k_2{};    ///< [N/m]
  Real gamma_p{};       ///< [m]
  Real gamma_elastic{}; ///< 0; everything where k_2 = k_1
  Real gamma_limit{};

  static constexpr double force_power = 1; ///< the springs do not grow with the spheres

  [[nodiscard]] std::vector<double> kinks() const { return {gamma_p}; }

  [[nodiscard]] PLATEN_HOT Loading<Real> loading(const Real& gamma) const {
    using std::sqrt;
    const Real a = sqrt(gamma / pair.A);
    if (gamma <= gamma_p) return {k_1 * gamma, k_1, a, Real(1), Real(0)};
    return {k_1 * gamma_p + k_2 * (gamma - gamma_p), k_2, a, Real(1), Real(0)};
  }

  [[nodiscard]] PLATEN_HOT bool in_range(const Real& gamma) const { return gamma <= gamma_p; }

  [[nodiscard]] PLATEN_FUNCTION Real work(const Real& gamma) const {
    const Real soft = smaller(gamma, gamma_p), more = gamma - soft;
    return k_1 * soft * soft / Real(2) + more * (k_1 * soft + k_2 * more / Real(2));
  }

  [[nodiscard]] PLATEN_HOT Unloading<Real> unloading(const Real& gamma, const Loading<Real>& peak) const {
    const Real k = gamma < gamma_p ? k_1 + (k_2 - k_1) * (gamma / gamma_p) : k_2;
    return {k / peak.F, Real(1)};
  }
};

inline Luding<double> prepare(const LudingMaterial& m, double R1, double R2) {
  constexpr auto name = "luding";
  require(name, "k_1_N_per_m", m.k_1, positive);
  require(name, "k_2_N_per_m", m.k_2, {m.k_1, infinity, false, true});
  require(name, "phi_f", m.phi_f, {0, 1, true, false});
  require(name, "radius_m", R1, radius_or_plane);
  require(name, "radius2_m", R2, radius_or_plane);
  Luding<double> law;
  law.pair = make_pair({1 / R1, 1, 0}, {1 / R2, 1, 0}); // a modulus of 1 Pa that nothing reads
  law.k_1 = m.k_1;
  law.k_2 = m.k_2;
  law.gamma_p = m.k_2 / (m.k_2 - m.k_1) * m.phi_f * 2 / law.pair.A; // infinity for k_2 = k_1
  law.gamma_limit = 1000 / law.pair.x_per_gamma;
  law.gamma_elastic = m.k_2 == m.k_1 ? law.gamma_limit : 0;
  return law;
}

/// The spring is that of the pair: both sides must have the same.
inline Luding<double> prepare(const LudingMaterial& m1, double R1, const LudingMaterial& m2, double R2) {
  if (m1.k_1 != m2.k_1 || m1.k_2 != m2.k_2 || m1.phi_f != m2.phi_f)
    throw BadParameter("luding: both sides must have the same springs");
  return prepare(m1, R1, R2);
}

inline Luding<double> prepare(const LudingMaterial& m, double R) { return prepare(m, R, R); }

inline Luding<double> prepare_on_rigid_plane(const LudingMaterial& m, double R) {
  return prepare(m, R, infinity);
}

} // namespace platen::law
