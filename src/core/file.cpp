#include "core/file.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

namespace platen::core {
namespace {

namespace fs = std::filesystem;

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

[[noreturn]] void fail(std::string_view what, const fs::path& path, int error) {
  const bool full = error == ENOSPC || error == EDQUOT || error == EFBIG;
  throw IoError(
      fmt::format("{}: {}: {}{}", path.string(), what, std::strerror(error),
                  full ? "; free some space, or name another place; files written before are whole" : ""));
}

} // namespace

std::string read_file(const fs::path& path) {
  if (fs::is_directory(path)) throw IoError(fmt::format("{}: is a folder, a file is wanted", path.string()));
  File file(std::fopen(path.c_str(), "rb"));
  if (!file) fail("cannot be read", path, errno);
  std::string content;
  char buffer[1 << 16];
  while (const auto count = std::fread(buffer, 1, sizeof buffer, file.get())) content.append(buffer, count);
  if (std::ferror(file.get())) fail("cannot be read", path, errno);
  return content;
}

fs::path temporary_name(const fs::path& file) {
  // The extension stays: programs that draw choose their format by it.
  return file.parent_path() /
         fmt::format(".{}.{}{}", file.stem().string(), ::getpid(), file.extension().string());
}

void put_in_place(const fs::path& temporary, const fs::path& file) {
  std::error_code error;
  fs::rename(temporary, file, error);
  if (error) fail("cannot be written", file, error.value());
}

void write_file(const fs::path& path, std::string_view content) {
  const fs::path temporary = temporary_name(path);
  File file(std::fopen(temporary.c_str(), "wb"));
  if (!file) fail("cannot be written", path, errno);
  const bool written = std::fwrite(content.data(), 1, content.size(), file.get()) == content.size();
  const bool closed = std::fclose(file.release()) == 0; // a full disk may show itself only here
  if (!written || !closed) {
    const int error = errno;
    ::unlink(temporary.c_str());
    fail("cannot be written", path, error);
  }
  put_in_place(temporary, path);
}

void prepare_folder(const fs::path& folder, std::string_view option) {
  std::error_code error;
  fs::create_directories(folder, error);
  std::string reason = error ? error.message() : "";
  if (reason.empty() && !fs::is_directory(folder)) reason = "it is a file";
  if (reason.empty() && ::access(folder.c_str(), W_OK | X_OK) != 0) reason = std::strerror(errno);
  if (!reason.empty())
    throw IoError(
        fmt::format("{}: the output folder cannot be written ({}); name another with {}, or make this one "
                    "writable",
                    folder.string(), reason, option));
}

} // namespace platen::core
