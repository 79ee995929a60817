#include "core/file.hpp"

#include "core/error.hpp"

#include <fcntl.h>
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

/// The error, 0 for none. Some file systems, and what is no file, have nothing to bring to a disk.
int sync(int file) {
  if (::fsync(file) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS) return 0;
  return errno;
}

std::string content_of(std::FILE* file, const fs::path& path) {
  std::string content;
  char buffer[1 << 16];
  while (const auto count = std::fread(buffer, 1, sizeof buffer, file)) content.append(buffer, count);
  if (std::ferror(file)) fail("cannot be read", path, errno);
  return content;
}

/// `named`: as messages call the file.
void write(const fs::path& path, std::string_view content, const fs::path& named) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) fail("cannot be written", named, errno);
  int error = 0;
  while (!content.empty() && error == 0) {
    const auto count = ::write(file, content.data(), content.size());
    if (count > 0) content.remove_prefix(static_cast<std::size_t>(count));
    else if (count == 0) error = EIO;
    else if (errno != EINTR) error = errno;
  }
  if (error == 0) error = sync(file); // a full disk or a server's quota may show itself only here
  if (::close(file) != 0 && error == 0) error = errno;
  if (error == 0) return;
  ::unlink(path.c_str());
  fail("cannot be written", named, error);
}

} // namespace

bool is_there(const fs::path& path) {
  std::error_code error;
  return path == standard_stream || fs::exists(path, error);
}

std::string read_file(const fs::path& path) {
  if (path == standard_stream) {
    static const std::string input = content_of(stdin, path);
    return input;
  }
  if (fs::is_directory(path)) throw IoError(fmt::format("{}: is a folder, a file is wanted", path.string()));
  File file(std::fopen(path.c_str(), "rb"));
  if (!file) fail("cannot be read", path, errno);
  return content_of(file.get(), path);
}

fs::path temporary_name(const fs::path& file) {
  // The extension stays: programs that draw choose their format by it.
  return file.parent_path() /
         fmt::format(".{}.{}{}", file.stem().string(), ::getpid(), file.extension().string());
}

void write_through(const fs::path& path, std::string_view content) { write(path, content, path); }

void sync_folder(const fs::path& path) {
  const fs::path folder = path.empty() ? "." : path;
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) fail("cannot be read", folder, errno);
  const int error = sync(file);
  ::close(file);
  if (error != 0) fail("cannot be written", folder, error);
}

void put_in_place(const fs::path& temporary, const fs::path& file) {
  std::error_code error;
  fs::rename(temporary, file, error);
  if (error) {
    ::unlink(temporary.c_str());
    fail("cannot be written", file, error.value());
  }
  sync_folder(file.parent_path());
}

void write_file(const fs::path& path, std::string_view content) {
  if (path == standard_stream) {
    if (std::fwrite(content.data(), 1, content.size(), stdout) != content.size() || std::fflush(stdout) != 0)
      throw IoError(fmt::format("the output could not be written: {}", std::strerror(errno)));
    return;
  }
  const fs::path temporary = temporary_name(path);
  write(temporary, content, path);
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
