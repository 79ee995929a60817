#pragma once
// A press with its results in a folder: what `press` and `derive` share.

#include "app/output_folder.hpp"
#include "press/simple.hpp"

namespace platen::app {

/// Presses with progress on standard error and writes case.toml, curve.csv, summary.json and, where fields
/// were asked for, zones.svg. A press that stops early is written the same; then ConvergenceError or
/// Interrupted is thrown.
press::Result press_into(const press::Case&, const OutputFolder&);

/// The sentences about a press that its user must read, on standard error.
void print_flags(const press::Result&);

} // namespace platen::app
