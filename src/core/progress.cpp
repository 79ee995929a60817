#include "core/progress.hpp"

#include "core/say.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

namespace platen::core {

namespace {

/// As if the rest went as fast as what is done; nothing before that says something.
std::string time_left(double fraction, double seconds) {
  if (!(fraction > 0.05 && fraction < 1 && seconds > 2)) return {};
  const double left = seconds * (1 - fraction) / fraction;
  if (left < 100) return fmt::format(", about {:.0f} s left", left);
  if (left < 6000) return fmt::format(", about {:.0f} min left", left / 60);
  return fmt::format(", about {:.0f} h left", left / 3600);
}

} // namespace

Progress::Progress(std::string label) : label_(std::move(label)), terminal_(::isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (drawn_) say("\n");
}

void Progress::show(double fraction, std::string_view note) {
  fraction = std::clamp(fraction, 0.0, 1.0);
  const auto now = Clock::now();
  const double seconds = std::chrono::duration<double>(now - start_).count();
  if (terminal_) {
    // Ten pictures a second are as many as an eye wants.
    if (fraction < 1 && drawn_ && now - last_ < std::chrono::milliseconds(100)) return;
    constexpr int width = 30;
    const int filled = static_cast<int>(fraction * width);
    say(fmt::format("\r{} [{:=<{}}{: <{}}] {:3.0f} %  {}  {:.0f} s{}\x1b[K", label_, "", filled, "",
                    width - filled, 100 * fraction, note, seconds, time_left(fraction, seconds)));
    drawn_ = true;
    last_ = now;
  } else if (const int tenths = static_cast<int>(10 * fraction); tenths > tenths_) {
    say(fmt::format("{}: {} %, {}, {:.0f} s{}\n", label_, 10 * tenths, note, seconds,
                    time_left(fraction, seconds)));
    tenths_ = tenths;
  }
}

} // namespace platen::core
