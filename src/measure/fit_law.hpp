#pragma once
// A law fitted to a curve, whichever it is: what `platen fit` does.

#include "fit/agarwal.hpp"
#include "fit/fitted_law.hpp"
#include "fit/pressed.hpp"
#include "fit/shahin.hpp"
#include "fit/wang.hpp"
#include "measure/input_curve.hpp"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace platen::measure {

struct FitOptions {
  std::string law, variant = "published";
  /// What a measured curve does not say of its material.
  std::optional<double> sigma_ref_Pa, E_Pa, nu, phi_deg, sigma_c_Pa, inverse_m;
  bool despite_doubts = false;
  bool wants_card = true; ///< a curve without elasticity has none
};

struct Fitting {
  press::Curve curve; ///< completed
  std::variant<fit::PressedFit, fit::FittedLaw, fit::WangFit, fit::AgarwalFit, fit::ShahinFit> fit;
  std::optional<fit::LawCard> card;
  std::vector<std::string> doubts; ///< that do not refuse; they are in the card
};

/// InvalidInput for what the curve does not say, and for what cannot be believed of it.
Fitting fit_law(const InputCurve&, const FitOptions&, const fit::Say&);

} // namespace platen::measure
