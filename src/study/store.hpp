#pragma once
// The run store: a folder of finished runs, runs/KEY/. A run is written under a temporary name and renamed,
// so it is whole or not there. claims/KEY keeps two workers from one run.

#include "core/version.hpp"
#include "press/simple.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace platen::study {

/// SHA-256 of the resolved case and the engine number, in 32 digits.
std::string key_of(const press::Case&, int engine = core::engine);

/// The right to press one run; given back when it goes out of scope.
class Claim {
 public:
  explicit Claim(std::filesystem::path file) : file_(std::move(file)) {}
  Claim(Claim&& other) noexcept : file_(std::move(other.file_)) { other.file_.clear(); }
  Claim& operator=(Claim&&) = delete;
  ~Claim();
  /// Says that the worker is alive; workers on other hosts believe it for a quarter of an hour.
  void refresh() const;

 private:
  std::filesystem::path file_;
};

class Store {
 public:
  /// Opens without writing. `study`: its name.
  Store(std::filesystem::path folder, std::string study);

  /// Makes the folder, or checks it: IoError where it cannot be written, InvalidInput for runs of another
  /// study or another engine number, unless these are to be left beside the new ones.
  void open_for_writing(bool recompute) const;

  enum class State { missing, done, failed };
  State state(const std::string& key) const;
  std::filesystem::path run(const std::string& key) const { return folder_ / "runs" / key; }
  const std::filesystem::path& folder() const { return folder_; }

  /// Nothing when another worker has it. The claim of a process that died on this host, or was silent for a
  /// quarter of an hour on another, is taken over.
  std::optional<Claim> claim(const std::string& key) const;

  struct Cost {
    double cpu_s = 0, wall_s = 0;
  };
  /// IoError leaves nothing half-written.
  void keep(const std::string& key, const press::Case&, const press::Result&, Cost) const;
  void forget(const std::string& key) const;
  Cost cost(const std::string& key) const;
  /// Why the run failed; empty for one that is done.
  std::string failure(const std::string& key) const;
  /// Copies runs that are not here yet; how many.
  int merge(const Store& from) const;

 private:
  std::filesystem::path folder_;
  std::string study_;
};

} // namespace platen::study
