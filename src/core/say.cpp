#include "core/say.hpp"

#include <cstdio>

namespace platen::core {

void say(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

} // namespace platen::core
