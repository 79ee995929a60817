#pragma once
// What `platen import` writes.

#include "measure/machine.hpp"
#include "measure/stages.hpp"

#include <string>
#include <vector>

namespace platen::measure {

/// Columns particle, diameter_m, time_s, travel_m, force_N, branch of all particles: as measured in SI units,
/// the machine's part of the travel taken off, signs turned. `platen calibrate` and `platen fit` read it.
std::string curve_text(const Measurement&, const std::vector<Stages>&, const Machine&);

} // namespace platen::measure
