#pragma once
// The law `shahin` fitted to one pressed curve of a material sigma = kappa epsilon^(1/m): the radius (3.47)
// is linear in its three factors, the hardness (3.48), (3.58) is fitted by its own. Formulas:
// platen/law/shahin_curve.hpp.

#include "fit/large_deformation.hpp"
#include "platen/law/shahin_curve.hpp"

namespace platen::fit {

struct ShahinFit {
  law::LoadingCase loading = law::LoadingCase::simple;
  double inverse_m = 0;
  double E_over_kappa = 0;
  double x_from = 0, x_to = 0; ///< fitted rows
  std::size_t points = 0;
  law::ShahinCoefficients<double> fitted, published; ///< the latter of the variant hardening-minimum
  std::vector<std::string_view>
      held; ///< keys that the curve does not determine, left at the published values
  std::vector<std::string_view> on_bound; ///< keys that ended where the search does
  Deviations of_fitted, of_published;
};

/// D_i from the radius; the others by least squares of ln H_bar and ln F_bar with that radius, over
/// loaded_rows() up to 0.98 of the filled cell, where (3.58) goes to infinity: q in simple loading alone,
/// x_min, H_min and L in a cell alone. What is not found stays as published. Throws core::InvalidInput where
/// the curve says no E, kappa (sigma_ref) or 1/m in [0, 1], no contact radius, or another experiment than
/// simple, die or hydrostatic.
ShahinFit fit_shahin(const press::Curve&);

/// The law with the fitted coefficients, and its deviations from this curve.
LawCard law_card(const press::Curve&, const ShahinFit&, std::string_view curve_text);

} // namespace platen::fit
