#pragma once

#include <string_view>

namespace platen::core {

inline constexpr std::string_view version = PLATEN_VERSION;

/// Raised by hand whenever the results of a press change; part of every key of the run store.
inline constexpr int engine = 6;

} // namespace platen::core
