#pragma once
// In the debug preset an invalid operation, a division by zero or an overflow ends the program. A test that
// means them says so with one of these, named after what it means.

#include <cfenv>

namespace platen::testing {

class Untrapped {
 public:
  Untrapped() { std::feholdexcept(&before_); }
  ~Untrapped() { std::fesetenv(&before_); }
  Untrapped(const Untrapped&) = delete;
  Untrapped& operator=(const Untrapped&) = delete;

 private:
  std::fenv_t before_;
};

} // namespace platen::testing
