#pragma once
// The run store: a folder of finished runs, runs/KEY/. A run is written under a temporary name and renamed,
// so it is whole or not there. claims/KEY keeps two workers from one run.

#include "core/version.hpp"
#include "press/case.hpp"
#include "press/result.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace platen::study {

/// What names a run: a schema number, the engine, and what of its case differs from the defaults. Kept beside
/// each run as identity.txt.
std::string identity_of(const press::Case&, int engine = core::engine);

/// SHA-256 of that, in 32 digits.
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

/// What becomes of runs that another engine computed.
enum class OldRuns { ask, keep, recompute };

class Store {
 public:
  /// Opens without writing. `study`: its name. A store of another engine is read as if its runs were kept.
  /// InvalidInput for runs of another study.
  Store(std::filesystem::path folder, std::string study);

  /// Makes the folder, or checks it, and sweeps up what killed processes left. IoError where it cannot be
  /// written; InvalidInput for runs of another engine of which nobody said what should become.
  void open_for_writing(OldRuns);

  /// Of the run that is there: by this engine, else by one whose runs are kept. Else the key of a new one.
  std::string key(const press::Case&) const;
  /// Engines whose runs count, this program's first.
  const std::vector<int>& engines() const { return engines_; }

  enum class State { missing, done, failed };
  State state(const std::string& key) const;
  std::filesystem::path run(const std::string& key) const { return folder_ / "runs" / key; }
  const std::filesystem::path& folder() const { return folder_; }

  /// Nothing when another worker has it, or it is there already. The claim of a process that died on this
  /// host, or was silent for a quarter of an hour on another, is taken over.
  std::optional<Claim> claim(const std::string& key) const;
  /// Runs being pressed by live workers.
  int claimed() const;

  struct Cost {
    double cpu_s = 0, wall_s = 0;
  };
  /// IoError leaves nothing half-written. A run that is there already stays as it is.
  void keep(const std::string& key, const press::Case&, const press::Result&, Cost) const;
  void forget(const std::string& key) const;
  Cost cost(const std::string& key) const;
  /// Why the run failed; empty for one that is done.
  std::string failure(const std::string& key) const;
  /// Opens for writing and copies runs that are not here yet; how many. InvalidInput, before anything is
  /// written, where one is no store, or has runs of an engine whose runs do not count here and are not to be
  /// kept.
  int merge(const std::vector<Store>& others, OldRuns);

 private:
  void sweep() const;
  std::filesystem::path temporary(const std::string& key) const;

  std::filesystem::path folder_;
  std::string study_;
  std::vector<int> engines_;
};

} // namespace platen::study
