#pragma once
// A measured particle under confinement.

#include "calibrate/confined.hpp"

#include <filesystem>

namespace platen::plot {

/// Left F/(pi R^2) over delta/R, measured, fitted, and what it would be in a die and from all sides; right
/// the contact radius; both with bands. SVG or PNG by file ending. Throws InvalidInput, IoError.
void confined_prediction(const calibrate::Calibration&, const std::vector<calibrate::ConfinedCurve>&,
                         const std::filesystem::path&);

} // namespace platen::plot
