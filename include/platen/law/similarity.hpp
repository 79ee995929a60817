#pragma once
// Rigid-plastic spheres with power-law hardening, sigma = kappa epsilon^(1/m): the similarity solution of
// Biwa & Storakers as given by Shahin (2.4)-(2.8), (3.4)-(3.8), and its curvature-corrected radius (B.24).
//   F = pi k A^(1/m) kappa_bar a^(2 + 1/m),   k = 3 * 6^(-1/m),   kappa_bar = (kappa1^-m + kappa2^-m)^(-1/m)
//   a = sqrt(2 c^2 gamma/A)                                              (2.5), c^2 = 1.43 exp(-0.97/m)
//   a^2 = (2/B) (sqrt(A^2 + 2 B c^2 gamma) - A)                          (B.24)
// Small strain, contacts that do not see each other: valid to delta/R of about 0.03 (text after (2.8)).
// (B.24) applies the constant c^2 of the r^2 term to the r^4 term as well, which is not exact; kept as
// published. E and nu serve unloading only.

#include "platen/law/contact.hpp"
#include "platen/law/pair.hpp"
#include "platen/law/parameter_reader.hpp"

namespace platen::law {

enum class SimilarityVariant : unsigned char { published, curvature_corrected };

struct SimilarityMaterial {
  double E = 0;         ///< Young's modulus, for unloading [Pa]
  double nu = 0;        ///< Poisson's ratio, in [0, 0.5)
  double kappa = 0;     ///< strength coefficient [Pa]
  double inverse_m = 0; ///< hardening exponent 1/m, in [0, 1]; the same on both sides
  SimilarityVariant variant = SimilarityVariant::published;

  static LawInfo info() {
    return {"similarity",
            "rigid-plastic spheres with power-law hardening, small strain",
            "Biwa & Storakers; Shahin (2.4)-(2.8), (B.24)",
            "force below Hertz's; delta/R <= 0.03, 0 <= 1/m <= 1",
            "published|curvature-corrected",
            {youngs_modulus(), poissons_ratio(), strength_coefficient(), hardening_exponent()}};
  }
  static SimilarityMaterial read(const Reader& p) {
    return {p("E_Pa"), p("nu"), p("kappa_Pa"), p("inverse_m"),
            p.variant == "published" ? SimilarityVariant::published : SimilarityVariant::curvature_corrected};
  }
};

template <class Real = double> struct Similarity {
  using Scalar = Real;
  BasicPair<Real> pair;
  Real inverse_m{};
  Real c2{};            ///< c^2 (2.5)
  Real force_scale{};   ///< pi k A^(1/m) kappa_bar [N/m^(2+1/m)]
  Real gamma_elastic{}; ///< 0
  Real gamma_limit{};
  double x_elastic = 0; ///< below, the force is above Hertz's
  SimilarityVariant variant = SimilarityVariant::published;

  static constexpr double x_valid = 0.03;

  [[nodiscard]] PLATEN_HOT Loading<Real> loading(const Real& gamma) const {
    using std::pow, std::sqrt;
    Real a2 = Real(2) * c2 * gamma / pair.A;
    Real log_slope(1); // d ln a^2 / d ln gamma
    if (variant == SimilarityVariant::curvature_corrected) {
      const Real root = sqrt(pair.A * pair.A + Real(2) * pair.B * c2 * gamma);
      a2 = Real(4) * c2 * gamma / (root + pair.A); // (B.24) without its cancellation
      log_slope = (root + pair.A) / (Real(2) * root);
    }
    const Real a = sqrt(a2);
    const Real F = force_scale * a2 * pow(a, inverse_m);
    // The steepest log slope is the first; the radius, and with it the unloading slope, grows like
    // gamma^(1/2), at large overlap of the corrected form like gamma^(1/4).
    const Real n = Real(1) + inverse_m / Real(2);
    return {F, n * log_slope * F / gamma, a, n, Real(variant == SimilarityVariant::published ? 0.5 : 0.25)};
  }

  [[nodiscard]] PLATEN_HOT bool in_range(const Real& gamma) const {
    const Real x = gamma * pair.x_per_gamma;
    return Real(x_elastic) <= x && x <= Real(x_valid);
  }

  [[nodiscard]] PLATEN_FUNCTION Real work(const Real& gamma) const {
    const Loading<Real> at = loading(gamma);
    if (variant == SimilarityVariant::published) return at.F * gamma / (Real(2) + inverse_m / Real(2));
    const Real a2 = at.a * at.a; // integral of F(a) (A a + B a^3/2)/c^2 da
    return at.F * a2 / c2 * (pair.A / (Real(4) + inverse_m) + pair.B * a2 / (Real(12) + Real(2) * inverse_m));
  }

  [[nodiscard]] PLATEN_HOT Unloading<Real> unloading(const Real& gamma, const Loading<Real>& peak) const {
    return unloading_from_slope(gamma, peak, pair.unloading_slope(peak.a) * gamma, Real(1.5));
  }
};

/// kappa_bar (2.8). With 1/m = 0 the softer side alone.
inline double similarity_strength(double kappa1, double kappa2, double inverse_m) {
  const double soft = kappa1 < kappa2 ? kappa1 : kappa2, hard = kappa1 < kappa2 ? kappa2 : kappa1;
  if (inverse_m == 0) return soft;
  return soft * std::pow(1 + std::pow(soft / hard, 1 / inverse_m), -inverse_m);
}

namespace detail {
inline void check(const SimilarityMaterial& m) {
  require("similarity", "kappa_Pa", m.kappa, {0, infinity, true, false}); // infinity: a rigid side
  require("similarity", "inverse_m", m.inverse_m, {0, 1});
  require("similarity", "E_Pa", m.E, {0, infinity, true, false});
  require("similarity", "nu", m.nu, poisson);
  if (m.kappa < infinity) require_softer_than_elastic("similarity", m.kappa, m.E);
}
} // namespace detail

inline Similarity<double> prepare(const SimilarityMaterial& m1, double R1, const SimilarityMaterial& m2,
                                  double R2) {
  detail::check(m1);
  detail::check(m2);
  require("similarity", "radius_m", R1, radius_or_plane);
  require("similarity", "radius2_m", R2, radius_or_plane);
  require("similarity", "inverse_m of the second side", m2.inverse_m, {m1.inverse_m, m1.inverse_m});
  Similarity<double> law;
  law.pair = make_pair(sphere(R1, m1.E, m1.nu), sphere(R2, m2.E, m2.nu));
  law.variant = m1.variant;
  law.inverse_m = m1.inverse_m;
  law.c2 = 1.43 * std::exp(-0.97 * m1.inverse_m);
  const double k = 3 * std::pow(6, -m1.inverse_m);
  const double kappa_bar = similarity_strength(m1.kappa, m2.kappa, m1.inverse_m);
  require("similarity", "kappa_Pa of the softer side", kappa_bar, positive);
  law.force_scale = std::numbers::pi * k * std::pow(law.pair.A, m1.inverse_m) * kappa_bar;
  law.gamma_limit = 1000 / law.pair.x_per_gamma;
  law.x_elastic = below_hertz_from(law.pair, law.x_valid / law.pair.x_per_gamma,
                                   [&](double gamma) { return law.loading(gamma).F; }) *
                  law.pair.x_per_gamma;
  return law;
}

inline Similarity<double> prepare(const SimilarityMaterial& m, double R) { return prepare(m, R, m, R); }

inline Similarity<double> prepare_on_rigid_plane(const SimilarityMaterial& m, double R) {
  SimilarityMaterial rigid = m;
  rigid.kappa = rigid.E = infinity;
  return prepare(m, R, rigid, infinity);
}

} // namespace platen::law
