#pragma once
// A folder of results: one run at a time writes it, and what is in it belongs together.

#include <filesystem>
#include <initializer_list>
#include <string_view>

namespace platen::core {

class OutputFolder {
 public:
  /// Makes the folder. IoError when it cannot be written, or when another run is writing it.
  explicit OutputFolder(std::filesystem::path);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  std::filesystem::path operator/(std::string_view name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

  /// Removes results of an earlier run before new ones are written, lest they seem to belong together.
  void forget(std::initializer_list<std::string_view> names) const;
  /// The same for all files whose names start and end so.
  void forget_series(std::string_view start, std::string_view end) const;

 private:
  std::filesystem::path path_;
  int lock_ = -1;
};

} // namespace platen::core
