#pragma once

#include <chrono>

namespace platen::fe {

/// Adds the seconds that it lives.
class Stopwatch {
 public:
  explicit Stopwatch(double& seconds) : into(seconds) {}
  ~Stopwatch() { into += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& into;
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
};

} // namespace platen::fe
