#pragma once
// How far long work has come, on standard error: a bar on a terminal, a plain line now and then in a log.

#include <chrono>
#include <string>
#include <string_view>

namespace platen::core {

class Progress {
 public:
  explicit Progress(std::string label);
  ~Progress(); ///< leaves a terminal on a fresh line
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `fraction` in [0, 1]; `note` is short: where the work is.
  void show(double fraction, std::string_view note);

 private:
  using Clock = std::chrono::steady_clock;
  std::string label_;
  bool terminal_;
  bool drawn_ = false;
  int tenths_ = 0;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

} // namespace platen::core
