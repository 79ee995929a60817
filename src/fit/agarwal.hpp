#pragma once
// The law `agarwal` beside one pressed curve. Its contact radius,
//   a/R = sqrt(x) (D_1 - D_3 x + D_5 x^2),  x = gamma/2R = delta/R0 (2.13)
// is linear in D_i, which are fitted to the curve; hardness and force are the published closed forms, whose
// distance from the curve is told. Formulas: platen/law/agarwal_curve.hpp.

#include "fit/law_card.hpp"
#include "platen/law/agarwal_curve.hpp"
#include "press/curve.hpp"

#include <string_view>

namespace platen::fit {

/// Of a published form, relative to the curve, over the overlaps of the comparison.
struct Deviation {
  double largest = 0; ///< of |law/curve - 1|
  double rms = 0;     ///< over the rows
};

struct AgarwalFit {
  law::LoadingCase loading = law::LoadingCase::simple;
  double lambda = 0, zeta = 0;
  double delta_bar_limit = 0;                  ///< where the cell is filled; 0.5 for simple loading
  double delta_bar_from = 0, delta_bar_to = 0; ///< fitted rows
  std::size_t points = 0;
  law::RadiusPolynomial<double> fitted, published;
  double radius_rms = 0; ///< of fitted/curve - 1 over the fitted rows
  double compared_from = 0, compared_to = 0;
  std::size_t compared = 0;
  Deviation hardness, radius, force; ///< F/(pi a^2), a, F of the published form
  Deviation fitted_radius;           ///< a with the fitted D_i, over the same rows
};

/// D_i from rows of the loading branch with delta/R0 from 0.02 to the limit; deviations from 0.06 to 0.9 of
/// it. Throws core::InvalidInput where the curve says no E or sigma_ref, no contact radius, another
/// experiment than simple, die or hydrostatic, where the law has no such material, or with fewer than eight
/// rows to fit.
AgarwalFit fit_agarwal(const press::Curve&);

/// The published law for this material and loading, with its deviations from this curve: `agarwal` has no
/// parameters for D_i.
LawCard law_card(const press::Curve&, const AgarwalFit&, std::string_view curve_text);

} // namespace platen::fit
