#include "core/say.hpp"

#include <cstdio>
#include <string>

namespace platen::core {

void say(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

void say_line(std::string_view text) { say(std::string(text) + "\n"); }

} // namespace platen::core
