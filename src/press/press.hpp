#pragma once
// The virtual press.

#include "press/case.hpp"
#include "press/result.hpp"

namespace platen::press {

/// Presses: loads along the path; from each place of `unload_from` unloads a copy of the loaded state until
/// it separates, and loads it again where the case says so. Never throws ConvergenceError: what was computed
/// comes back with `failure` set. Throws core::InvalidInput for a case outside its range.
Result press(const Case&, const Progress& = {});

/// A simple press in space, on a wedge of hexahedra: for comparison.
Result press_in_space(const Case&, const Progress& = {});

} // namespace platen::press
