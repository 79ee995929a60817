#pragma once
// Files by which a driver of its own, as Dakota, GrainLearning or a script, asks what the particles say of
// parameters, and is told.

#include "calibrate/calibration.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace platen::calibrate {

/// Sets of the free parameters, in their order, from a CSV with a column for each; other columns are passed
/// over. InvalidInput for a column that is missing, and a cell that is no number.
std::vector<std::vector<double>> read_asked(const std::string& file, const std::vector<FreeParameter>&);

/// A row for each set: its parameters, deviance, R2, relative_l2. A set that is no material, or that the law
/// does not take, has deviance inf.
std::string told_csv(const Calibration&);
/// The same with the forces: measured, and of each set, particle by particle.
std::string told_json(const Calibration&);

} // namespace platen::calibrate
