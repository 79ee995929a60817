#pragma once
// "Did you mean": the known name closest to what was written.

#include <span>
#include <string>
#include <string_view>

namespace platen::core {

/// Edits (insert, delete, replace, swap of neighbours) between two names, upper and lower case alike.
int edit_distance(std::string_view, std::string_view);

/// The closest of the known names, empty when none is close enough to be meant.
std::string nearest(std::string_view written, std::span<const std::string> known);

/// "; did you mean 'sigma_y_Pa'?" when one is close, else "; known are: a, b, c".
std::string suggestion(std::string_view written, std::span<const std::string> known);

} // namespace platen::core
