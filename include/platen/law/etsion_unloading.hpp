#pragma once
// Loading of Kogut & Etsion (kogut_etsion.hpp), unloading of Etsion, Kligerman & Kadin, Int. J. Solids
// Struct. 42 (2005) 3716: Hertz's force of the flattened sphere, whose radius and residual overlap follow
// from force and contact radius at the largest overlap,
//   F = 4/3 E* sqrt(R_res) (gamma - gamma_res)^(3/2),   R_res = 4 E* a_max^3/(3 F_max)
//   gamma_res = gamma_max - 3 F_max/(4 E* a_max)
// This closed form was seen in an independent program that cites the paper; it leaves F_max with the slope
// 2 E* a_max of a flat punch. The paper's other form, three fitted powers of omega_max, could not be
// confirmed from a second source and is left out. The paper's sphere hardens linearly (2 % of E), Kogut &
// Etsion's does not.
//   published  as printed, on the loading curve with its jumps. Between omega = 1 and 1.58 gamma_res is
//              negative: energy is created there, and nothing between is in range
//   joined     on the continuous loading curve, stiffened where it would create energy

#include "platen/law/kogut_etsion.hpp"

namespace platen::law {

struct EtsionUnloadingMaterial : KogutEtsionMaterial {
  static LawInfo info() {
    LawInfo all = KogutEtsionMaterial::info();
    all.name = "etsion-unloading";
    all.title = "kogut-etsion with the flattened sphere's unloading";
    all.source = "Etsion, Kligerman & Kadin (2005), closed form";
    all.validity = "to 110 overlaps of first yield, sigma_y (1 - nu^2)/E <= 0.01; published: not where it "
                   "creates energy";
    return all;
  }
  static EtsionUnloadingMaterial read(const Reader& p) { return {KogutEtsionMaterial::read(p)}; }
};

template <class Real = double> struct EtsionUnloading : KogutEtsion<Real> {
  using Base = KogutEtsion<Real>;
  using Scalar = Real;
  JointVariant variant = JointVariant::joined;

  /// gamma_max - gamma_res [m]
  [[nodiscard]] PLATEN_FUNCTION Real recovered(const Loading<Real>& peak) const {
    return Real(0.75) * peak.F / (this->pair.E_star * peak.a);
  }

  [[nodiscard]] PLATEN_HOT bool in_range(const Real& gamma) const {
    if (!Base::in_range(gamma)) return false;
    if (variant == JointVariant::joined || gamma <= this->gamma_elastic) return true;
    return recovered(this->loading(gamma)) <= gamma;
  }

  [[nodiscard]] PLATEN_HOT Unloading<Real> unloading(const Real& gamma, const Loading<Real>& peak) const {
    if (gamma <= this->gamma_elastic) return {Real(0), Real(1.5)}; // never followed: elastic
    if (variant == JointVariant::published) return {Real(1) / recovered(peak), Real(1.5)};
    return unloading_from_slope(gamma, peak, Real(2) * this->pair.E_star * peak.a * gamma, Real(1.5));
  }
};

inline EtsionUnloading<double> prepare(const EtsionUnloadingMaterial& m1, double R1,
                                       const EtsionUnloadingMaterial& m2, double R2) {
  require("etsion-unloading", "radius_m", R1, radius_or_plane);
  require("etsion-unloading", "radius2_m", R2, radius_or_plane);
  return {detail::prepare_kogut_etsion("etsion-unloading", m1, sphere(R1, m1.E, m1.nu), m2,
                                       sphere(R2, m2.E, m2.nu)),
          m1.variant};
}

inline EtsionUnloading<double> prepare(const EtsionUnloadingMaterial& m, double R) {
  return prepare(m, R, m, R);
}

inline EtsionUnloading<double> prepare_on_rigid_plane(const EtsionUnloadingMaterial& m, double R) {
  EtsionUnloadingMaterial rigid = m;
  rigid.sigma_y = rigid.E = infinity;
  return prepare(m, R, rigid, infinity);
}

} // namespace platen::law
