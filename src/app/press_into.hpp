#pragma once
// A press with its results in a folder: what `press` and `derive` share.

#include "plot/press_folder.hpp"

#include <string>

namespace platen::app {

struct Pressed {
  press::Result result; ///< what all experiments have
  std::string summary;  ///< summary.json
};

/// Presses with progress on standard error and writes it (plot/press_folder.hpp). A press that stops early is
/// written the same; then ConvergenceError or Interrupted is thrown. `estimate_error`: presses on a coarser
/// mesh too (press/estimate.hpp).
Pressed press_into(const press::Case&, const core::OutputFolder&, plot::Fields, bool estimate_error = false);

/// "within about 0.6 % in force and 0.4 % in contact radius of the limit of fine meshes", or nothing.
std::string error_words(const press::Result&);

/// The sentences about a press that its user must read, on standard error.
void print_flags(const press::Result&);

} // namespace platen::app
