#pragma once
// The laws by name and their parameters: the one table that validation, messages and the reference pages
// read.

#include "platen/law/shahin_curve.hpp"

#include <limits>
#include <string_view>
#include <vector>

namespace platen::law {

inline constexpr double required = std::numeric_limits<double>::quiet_NaN();

/// One parameter of a law; its key carries its unit. This table gives validation, messages and the reference.
struct Parameter {
  std::string_view key;
  std::string_view meaning;
  Range range;
  double fallback = required; ///< value where it is not given; NaN: it has to be
};

/// A parameter whose value is one of a few words, or a list of numbers ("0.1,0.3").
struct WordParameter {
  std::string_view key;
  std::string_view meaning;
  std::string_view values; ///< "simple|die|hydrostatic", the first is the fallback; empty: a list of numbers
};

struct LawInfo {
  std::string_view name;
  std::string_view title;
  std::string_view source;
  std::string_view validity;
  std::string_view variants; ///< "published|c1", the first is the default
  std::vector<Parameter> parameters;
  std::vector<WordParameter> words;
};

namespace detail {
template <class Table>
std::vector<Parameter> with_coefficients(std::vector<Parameter> parameters, const Table& coefficients) {
  for (const auto& c : coefficients) parameters.push_back({c.key, c.meaning, c.range, 0});
  return parameters;
}
} // namespace detail

inline const std::vector<LawInfo>& laws() {
  static const std::vector<LawInfo> all = [] {
    constexpr Range any_length{0, infinity, true, true}, fraction{0, 1};
    const Parameter R{"radius_m", "radius of the first sphere", any_length};
    const Parameter R2{"radius2_m", "radius of the second; inf: a plane of the second material",
                       radius_or_plane, 0};
    const Parameter E{"E_Pa", "Young's modulus", positive};
    const Parameter nu{"nu", "Poisson's ratio", poisson};
    const Parameter E2{"E2_Pa", "Young's modulus of the second body", positive, 0};
    const Parameter nu2{"nu2", "Poisson's ratio of the second body", poisson, -1};
    const Parameter kappa{"kappa_Pa", "strength coefficient of sigma = kappa epsilon^(1/m)", positive};
    const Parameter kappa2{"kappa2_Pa", "strength coefficient of the second body", positive, 0};
    const Parameter inverse_m{"inverse_m", "hardening exponent 1/m, the same on both sides", fraction};
    const WordParameter against{"against", "a second sphere, or a rigid plane", "sphere|plane"};
    const WordParameter loading{"loading", "how the particle is pressed", "simple|die|hydrostatic"};
    const Parameter sigma_y{"sigma_y_Pa", "uniaxial yield stress", positive};
    const Parameter sigma_y2{"sigma_y2_Pa", "uniaxial yield stress of the second body", positive, 0};
    const WordParameter at{"unload_delta_bar", "delta/R at which alpha and beta are given, at most 8", ""};
    return std::vector<LawInfo>{
        {"hertz",
         "elastic spheres",
         "Hertz (1882)",
         "delta/R <= 0.01",
         "published",
         {R, R2, E, nu, E2, nu2},
         {against}},
        {"similarity",
         "rigid-plastic spheres with power-law hardening, small strain",
         "Biwa & Storakers; Shahin (2.4)-(2.8), (B.24)",
         "delta/R <= 0.03, 0 <= 1/m <= 1",
         "published|curvature-corrected",
         {R, R2, E, nu, E2, nu2, kappa, kappa2, inverse_m},
         {against}},
        {"edmans-sinka",
         "compressible plastic particles, fitted curve",
         "Edmans & Sinka (6), (9)-(14)",
         "delta/R <= 0.5",
         "published|published-corrected|c1|hertz-like",
         {R,
          R2,
          {"sigma_ref_Pa", "stress that makes the force dimensionless: the material's yield stress",
           positive},
          E,
          nu,
          E2,
          nu2,
          {"k", "(6), initial slope of F/(pi R^2 sigma_ref) over delta/R", positive},
          {"delta_t", "(6), end of the first branch in delta/R", {0, 1, true, false}},
          {"a", "(6), rate of the exponential branch", {0, 50, true, false}},
          {"corner", "c1: half-width of the rounded corner over delta_t", {0, 1, true, true}, 0.5}},
         {against,
          at,
          {"alpha", "unloading exponents (9)", ""},
          {"beta", "secant stiffness ratios (11)", ""}}},
        {"wang",
         "granular geomaterials, Drucker-Prager",
         "Wang et al. (2018), (8)-(18)",
         "E 10-30 GPa, nu 0.1-0.3, phi 20-40 deg, sigma_c 5-50 MPa, a/R < 0.02; the contact radius is ours, "
         "provisional",
         "generic|fitted|published",
         {R,
          R2,
          E,
          nu,
          E2,
          nu2,
          {"phi_deg", "friction angle", {0, 60, false, true}},
          {"sigma_c_Pa", "uniaxial compressive strength", positive},
          {"a", "(16), both overlaps whole; 0: from Table 2", non_negative, 0},
          {"b", "(16); 0: from Table 2", non_negative, 0},
          {"m", "(17), fitted only", non_negative, 0},
          {"n", "(17), fitted only", non_negative, 0}},
         {against}},
        {"agarwal",
         "elastic, perfectly plastic spheres, large deformation",
         "Agarwal, Shahin & Gonzalez: Shahin's thesis, (2.12)-(2.48)",
         "lambda = E/((1 - nu^2) sigma_y) 117-5933 (formally >= 22.1); delta/R <= 0.5, in a cell a little "
         "past full",
         "hertz-radius|published",
         detail::with_coefficients({R, R2, E, nu, E2, nu2, sigma_y, sigma_y2}, agarwal_coefficients),
         {against,
          loading,
          {"kind", "secondary: the sides of a particle in a die; refused, see docs/laws/agarwal.md",
           "primary|secondary"}}},
        {"shahin",
         "rigid-plastic spheres with power-law hardening, large deformation",
         "Shahin's thesis, (3.45)-(3.59)",
         "0 <= 1/m <= 1; delta/R <= 0.5, in a cell until it is full",
         "published|hardening-minimum",
         detail::with_coefficients({R, R2, E, nu, E2, nu2, kappa, kappa2, inverse_m}, shahin_coefficients),
         {against, loading}},
        {"thornton-ning",
         "elastic spheres with a largest contact pressure; a straight line from yield on",
         "Thornton & Ning (1998), without adhesion",
         "delta/R <= 0.01 (ours; the paper states none)",
         "published",
         {R,
          R2,
          E,
          nu,
          E2,
          nu2,
          {"p_y_Pa", "largest contact pressure, 1.6 to 2.8 yield stresses", positive},
          {"p_y2_Pa", "largest contact pressure of the second body", positive, 0}},
         {against}},
        {"kogut-etsion",
         "elastic, perfectly plastic spheres, power laws in units of first yield",
         "Kogut & Etsion (2002); generic unloading",
         "to 110 overlaps of first yield",
         "joined|published",
         {R, R2, E, nu, E2, nu2, sigma_y, sigma_y2},
         {against}},
        {"etsion-unloading",
         "kogut-etsion with the flattened sphere's unloading",
         "Etsion, Kligerman & Kadin (2005), closed form",
         "to 110 overlaps of first yield; published: not where it creates energy",
         "joined|published",
         {R, R2, E, nu, E2, nu2, sigma_y, sigma_y2},
         {against}},
        {"jackson-green",
         "elastic, perfectly plastic spheres, hardness falling with the contact radius",
         "Jackson & Green (2005); generic unloading",
         "a/R <= 0.41, sigma_y (1 - nu^2)/E <= 0.01",
         "joined|published",
         {R, R2, E, nu, E2, nu2, sigma_y, sigma_y2},
         {against}},
        {"mdr",
         "elastic, perfectly plastic spheres, pressure falling with overlap: the pair kernel",
         "Zunker & Kamrin (2024), as in LAMMPS; without bulk response, growing radius, adhesion",
         "delta/R <= 0.75; published: not where it may create energy",
         "stiffened|published",
         {R, R2, E, nu, E2, nu2, sigma_y, sigma_y2},
         {against}},
        {"luding",
         "linear springs with hysteresis, calibrated",
         "Luding (2008), without adhesion",
         "for the radius it is calibrated at, to the overlap where k_2 is reached",
         "published",
         {R,
          R2,
          {"k_1_N_per_m", "loading stiffness", positive},
          {"k_2_N_per_m", "largest unloading stiffness, at least k_1", positive},
          {"phi_f", "plasticity depth over the reduced diameter", {0, 1, true, false}}},
         {against}},
        {"eepa",
         "springs of overlap^n with hysteresis, calibrated",
         "Thakur et al. (2014), without adhesion; k_1 as in LAMMPS",
         "as calibrated",
         "published",
         {R,
          R2,
          E,
          nu,
          E2,
          nu2,
          {"lambda_p", "contact plasticity 1 - k_1/k_2", {0, 1, false, true}},
          {"n", "exponent", {1, 2}, 1.5}},
         {against}},
    };
  }();
  return all;
}

} // namespace platen::law
