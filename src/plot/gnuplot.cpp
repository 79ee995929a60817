#include "plot/gnuplot.hpp"

#include "core/error.hpp"
#include "core/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

extern char** environ;

namespace platen::plot {

namespace fs = std::filesystem;

Format format_of(const fs::path& file) {
  if (file.extension() == ".svg") return Format::svg;
  if (file.extension() == ".png") return Format::png;
  throw core::InvalidInput(fmt::format("{}: a picture's name ends in .svg or .png, not in '{}'",
                                       file.string(), file.extension().string()));
}

std::string terminal(const fs::path& file, int width, int height, int font_size) {
  if (format_of(file) == Format::svg)
    return fmt::format(
        "set terminal svg size {},{} dynamic rounded enhanced font 'Helvetica, Arial, sans-serif,{}' "
        "background rgb 'white'\n",
        width, height, font_size);
  // twice the pixels: a PNG is shown on dense displays as well
  return fmt::format("set terminal pngcairo size {},{} rounded enhanced font 'sans,{}' fontscale 1.5 "
                     "linewidth 2 dashlength 2 background rgb 'white'\n",
                     2 * width, 2 * height, font_size);
}

std::string gnuplot_string(std::string_view words) {
  std::string result = "\"";
  for (const char c : words) {
    if (c == '"' || c == '\\') result += '\\';
    result += static_cast<unsigned char>(c) < ' ' ? ' ' : c; // a line break would end the command
  }
  return result + '"';
}

namespace {

/// Removes what is left of a scratch file, whatever happens.
struct Scratch {
  fs::path path;
  ~Scratch() {
    std::error_code ignored;
    fs::remove(path, ignored);
  }
};

constexpr const char* not_found =
    "gnuplot, which draws the pictures, was not found: install the package gnuplot-nox";

/// Exit status of `gnuplot script`, its standard error in `messages`.
int spawn_gnuplot(const fs::path& script, const fs::path& messages) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                   0600);
  std::string name = "gnuplot", argument = script.string();
  char* arguments[] = {name.data(), argument.data(), nullptr};
  pid_t child = 0;
  const int failed = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed == ENOENT || failed == EACCES) throw core::IoError(not_found);
  if (failed) throw core::IoError(fmt::format("gnuplot could not be started (error {})", failed));
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {}
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

} // namespace

void run_gnuplot(const std::string& script, const fs::path& file) {
  const fs::path temporary = core::temporary_name(file);
  const Scratch picture{temporary}, commands{temporary.string() + ".gnuplot"},
      messages{temporary.string() + ".log"};
  try {
    core::write_file(commands.path, fmt::format("set encoding utf8\nset output {}\n{}\nset output\n",
                                                gnuplot_string(picture.path.string()), script));
  } catch (const core::IoError&) { // the user knows the picture, not the scratch file beside it
    throw core::IoError(fmt::format("{}: cannot be written", file.string()));
  }
  const int status = spawn_gnuplot(commands.path, messages.path);
  if (status == 127) throw core::IoError(not_found);
  std::error_code missing;
  if (status != 0 || fs::file_size(picture.path, missing) == 0 || missing) {
    std::string said = core::read_file(messages.path);
    std::replace(said.begin(), said.end(), '\n', ' ');
    throw core::IoError(fmt::format("{}: gnuplot drew nothing (exit {}): {}", file.string(), status, said));
  }
  core::put_in_place(picture.path, file);
}

} // namespace platen::plot
