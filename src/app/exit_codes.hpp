#pragma once
// The exit codes, in this one place.

#include <array>
#include <string_view>

namespace platen::app {

enum Exit { done = 0, fault = 1, bad_input = 2, not_converged = 3, input_output = 4, interrupted = 130 };

struct ExitCode {
  Exit code;
  std::string_view what;
};

inline constexpr std::array<ExitCode, 6> exit_codes{{
    {done, "done"},
    {fault, "a fault in platen itself"},
    {bad_input, "bad input, of the command line too"},
    {not_converged, "a press or a fit did not converge; what was computed is kept"},
    {input_output, "a file, the disk or the memory"},
    {interrupted, "interrupted"},
}};

} // namespace platen::app
