#include "core/say.hpp"

#include <cstdio>
#include <string>

namespace platen::core {

namespace {

bool quiet = false;

void write(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

} // namespace

void say(std::string_view text) {
  if (!quiet) write(text);
}

void say_line(std::string_view text) { say(std::string(text) + "\n"); }

void be_quiet() { quiet = true; }

void say_last(std::string_view text) { write(std::string(text) + "\n"); }

} // namespace platen::core
