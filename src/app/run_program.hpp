#pragma once
// From what was typed to an exit code.

#include "app/command_line.hpp"

#include <functional>

namespace platen::app {

/// Runs the command that was typed, of those that `add` adds. What fails is said in one sentence on standard
/// error; the status is that of exit_codes.hpp.
int run_program(int argc, char** argv, const std::function<void(Program&)>& add);

} // namespace platen::app
