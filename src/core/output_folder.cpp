#include "core/output_folder.hpp"

#include "core/error.hpp"
#include "core/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <vector>

namespace platen::core {

OutputFolder::OutputFolder(std::filesystem::path path) : path_(std::move(path)) {
  prepare_folder(path_);
  lock_ = ::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  // The lock goes with the process, however it ends. File systems without locks are used without one.
  if (lock_ >= 0 && ::flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    ::close(lock_);
    throw IoError(fmt::format("{}: another run is writing into this folder; name another with -o, or wait",
                              path_.string()));
  }
}

OutputFolder::~OutputFolder() {
  if (lock_ >= 0) ::close(lock_);
}

void OutputFolder::forget(std::initializer_list<std::string_view> names) const {
  for (const auto name : names) {
    std::error_code error;
    std::filesystem::remove(path_ / name, error);
  }
}

void OutputFolder::forget_series(std::string_view start, std::string_view end) const {
  std::error_code error;
  std::vector<std::filesystem::path> found;
  for (const auto& entry : std::filesystem::directory_iterator(path_, error))
    if (const auto name = entry.path().filename().string(); name.starts_with(start) && name.ends_with(end))
      found.push_back(entry.path());
  for (const auto& file : found) std::filesystem::remove(file, error);
}

} // namespace platen::core
