#pragma once
// Measured particles as they came, and as they were fitted.

#include "calibrate/calibration.hpp"

#include <filesystem>
#include <vector>

namespace platen::plot {

/// Left, force over travel as measured: what was used, the way before contact, what was cut from a break on.
/// Right, the same without contact point, zero of the load cell and give of the machine, as F/(pi R^2) over
/// delta/R, with the law. SVG or PNG by file ending. Throws InvalidInput, IoError.
void measured_picture(const std::vector<measure::Measurement>&, const calibrate::Calibration&,
                      const std::filesystem::path&);

} // namespace platen::plot
