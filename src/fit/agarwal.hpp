#pragma once
// The law `agarwal` fitted to one pressed curve: the radius (2.13) is linear in D_i, the hardness of (2.48)
// is fitted by its own coefficients. Formulas: platen/law/agarwal_curve.hpp.

#include "fit/large_deformation.hpp"

namespace platen::fit {

struct AgarwalFit {
  law::LoadingCase loading = law::LoadingCase::simple;
  double lambda = 0, zeta = 0;
  double x_from = 0, x_to = 0; ///< fitted rows
  std::size_t points = 0;
  law::AgarwalCoefficients<double> fitted, published;
  std::vector<std::string_view>
      held; ///< keys that the curve does not determine, left at the published values
  std::vector<std::string_view> on_bound; ///< keys that ended where the search does
  Deviations of_fitted, of_published;     ///< as in the card, variant hertz-radius; variant published
  std::optional<double> Gamma;            ///< rho_V rho_S (2.28) at the fitted x_min, Fig. 2.17
  std::optional<double> side_onset;
  std::optional<SideMotion> sides;
};

/// D_i from the radius; the others by least squares of ln H_bar and ln F_bar with that radius, over
/// loaded_rows(). As in the thesis, the softening q and r are found in simple loading alone, x_min, H_min and
/// l in a cell alone; x_h only where it lies on the fitted rows. What is not found stays as published. Throws
/// core::InvalidInput where the curve says no E or sigma_ref, no contact radius, another experiment than
/// simple, die or hydrostatic, or where the law has no such material.
AgarwalFit fit_agarwal(const press::Curve&);

/// The law with the fitted coefficients, and its deviations from this curve.
LawCard law_card(const press::Curve&, const AgarwalFit&, std::string_view curve_text);

} // namespace platen::fit
