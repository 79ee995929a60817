#pragma once
// The ways in which Platen gives up. The program maps them to its exit codes: InvalidInput 2,
// ConvergenceError 3, IoError 4; Interrupted, which is no failure, 130.

#include <stdexcept>
#include <string>

namespace platen::core {

/// Something the user wrote is not admissible. The message is one sentence that names file, key and value,
/// and says what is allowed.
struct InvalidInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file or folder could not be read or written.
struct IoError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A nonlinear solution was not found. Recoverable: the caller may cut the step and try again.
struct ConvergenceError : std::runtime_error {
  ConvergenceError(const std::string& what, int step_, int iterations_, double relative_residual_)
      : std::runtime_error(what), step(step_), iterations(iterations_),
        relative_residual(relative_residual_) {}
  int step = 0;
  int iterations = 0;
  double relative_residual = 0;
};

/// The user asked to stop (SIGINT, SIGTERM); what was computed is already kept.
struct Interrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

} // namespace platen::core
