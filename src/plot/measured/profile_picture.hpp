#pragma once
// Profile likelihoods of a calibration.

#include "calibrate/calibration.hpp"

#include <filesystem>

namespace platen::plot {

/// For each profiled parameter what the deviance adds over its value, with the level of 95 % and the parabola
/// that the standard error stands for. SVG or PNG by file ending. Throws InvalidInput, IoError.
void profile_picture(const calibrate::Calibration&, const std::filesystem::path&);

} // namespace platen::plot
