#pragma once
// Messages on standard error.

#include <string_view>

namespace platen::core {

/// Writes the text as it is. Where standard error cannot be written it is lost: a message must not end the
/// work that it is about.
void say(std::string_view);
/// The same, as a line.
void say_line(std::string_view);
/// From here on `say` is silent; what ends the program is still said.
void be_quiet();
/// Says why the program ends, as a line.
void say_last(std::string_view);

} // namespace platen::core
