#pragma once
// The preset `debug` ends a program where an operation is invalid, divides by zero or overflows
// (cmake/traps.cpp).

#include <cfenv>

namespace platen::core {

/// While one lives no operation ends the program: kernels compute lanes that nobody asks for.
class NoFloatTraps {
 public:
  NoFloatTraps() { std::feholdexcept(&before_); }
  ~NoFloatTraps() { std::fesetenv(&before_); }
  NoFloatTraps(const NoFloatTraps&) = delete;
  NoFloatTraps& operator=(const NoFloatTraps&) = delete;

 private:
  std::fenv_t before_{};
};

} // namespace platen::core
