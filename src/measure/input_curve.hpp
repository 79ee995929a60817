#pragma once
// A curve for a fit: of a press, or measured. What is measured is doubted.

#include "fit/doubt.hpp"
#include "fit/law_card.hpp"
#include "measure/machine.hpp"
#include "measure/specimen.hpp"
#include "press/curve.hpp"

#include <string>

namespace platen::measure {

struct CurveOptions {
  ReadOptions read;
  Machine machine;
  bool despite_doubts = false; ///< of a particle that broke: what was before
};

struct InputCurve {
  std::string file, text;
  press::Curve curve;
  bool measured = false;        ///< no press wrote it
  fit::Remarks provenance = {}; ///< of an instrument's file: what was found, turned, cut and corrected
};

/// curve.csv of a press, columns delta_m,force_N, or a file of an instrument with one particle, whose contact
/// point and load cell zero are taken from the foot of the curve. InvalidInput.
InputCurve read_curve(const std::string& file, const CurveOptions&);
/// From the text of a curve.csv.
InputCurve read_curve(const std::string& file, std::string text, const CurveOptions&);

/// What can be doubted of a measured curve whatever the law.
fit::Claim claim_of(const press::Curve&, const std::string& file);

} // namespace platen::measure
