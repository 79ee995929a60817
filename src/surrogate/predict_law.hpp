#pragma once
// A law at once, from the surrogates of the catalogue; refused where they know nothing of the material.

#include "fit/law_card.hpp"
#include "material/models.hpp"
#include "surrogate/assess.hpp"

#include <functional>
#include <string>
#include <vector>

namespace platen::surrogate {

/// The law that is asked for, or, where none is, that which is predicted of the material: wang of rock
/// (drucker-prager: predict_rock()), pressed of others. InvalidInput where it is not predicted of such a
/// material.
std::string law_to_predict(const material::Material&, const std::string& asked);

struct PredictOptions {
  std::string law = "pressed", variant = "published"; ///< or edmans-sinka in a form of it
  bool quick = false;                                 ///< without the press on few elements that guides
  bool extrapolate = false;                           ///< guess outside of what was pressed
  std::string card = "CARD.toml";                     ///< how advice names the material
};

struct PredictedLaw {
  fit::LawCard card;
  Answer answer;
  std::vector<Near> near; ///< the three nearest runs
};

/// `say` is given what the user must read, a sentence each, "note: ..." or "warning: ...". InvalidInput where
/// the material is outside of what was pressed, unless extrapolation is allowed.
PredictedLaw predict_law(const material::Material&, const PredictOptions&,
                         const std::function<void(const std::string&)>& say);

} // namespace platen::surrogate
