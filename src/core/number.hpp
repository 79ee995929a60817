#pragma once
// Numbers as text, the same everywhere: the shortest text that reads back as the same number.

#include <optional>
#include <string>
#include <string_view>

namespace platen::core {

/// 0.1 → "0.1", 1e8 → "1e8", 441700000 → "441700000"; valid in TOML, CSV and JSON alike when finite.
std::string number_text(double);

/// The whole text as a number; nothing for anything else. Independent of the locale.
std::optional<double> number_from(std::string_view);

} // namespace platen::core
