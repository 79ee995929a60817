#pragma once
// A curve for `fit`: of a press, or measured. What is measured is doubted.

#include "app/measured_arguments.hpp"
#include "fit/doubt.hpp"
#include "fit/law_card.hpp"
#include "press/curve.hpp"

#include <string>

namespace platen::app {

struct InputCurve {
  press::Curve curve;
  bool measured = false;   ///< no press wrote it
  fit::Remarks provenance; ///< of an instrument's file: what was found, turned, cut and corrected
};

/// curve.csv of a press, columns delta_m,force_N, or a file of an instrument with one particle, whose contact
/// point and load cell zero are taken from the foot of the curve. InvalidInput.
InputCurve curve_of(const std::string& file, const MeasuredArguments&);

/// What can be doubted of a measured curve whatever the law.
fit::Claim claim_of(const press::Curve&, const std::string& file);

/// A law that is fitted to the contact radius cannot be fitted to a measurement.
void refuse_without_radius(const press::Curve&, const std::string& law, const std::string& file);

} // namespace platen::app
