#pragma once
// The run store: a folder of finished runs, runs/KEY/. A run is written under a temporary name, brought to
// the disk and renamed, so it is whole or not there; of two of one key the first stays. Its sums.txt says
// what was written. claims/KEY keeps two workers from one run.

#include "core/version.hpp"
#include "press/case.hpp"
#include "press/result.hpp"
#include "study/claims.hpp"

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

/// What becomes of runs that another engine computed.
enum class OldRuns { ask, keep, recompute };

class Store {
 public:
  /// Opens without writing. `study`: its name. A store of another engine is read as if its runs were kept.
  /// InvalidInput for runs of another study, and for a study.txt that cannot be read.
  Store(std::filesystem::path folder, std::string study, Pace = {});

  /// Makes the folder, or checks it, and sweeps up what killed processes left. IoError where it cannot be
  /// written; InvalidInput for runs of another engine of which nobody said what should become.
  void open_for_writing(OldRuns);

  /// Of the run that is there: by this engine, else by one whose runs are kept. Else the key of a new one.
  std::string key(const press::Case&) const;
  /// Engines whose runs count, this program's first.
  const std::vector<int>& engines() const { return engines_; }

  enum class State { missing, done, failed, damaged };
  /// At a glance: never damaged.
  State state(const std::string& key) const;
  /// What is wrong with the content of a run that is there; empty: nothing.
  std::string damage(const std::string& key) const;
  /// With its content looked at.
  State verified(const std::string& key) const;
  std::filesystem::path run(const std::string& key) const { return folder_ / "runs" / key; }
  const std::filesystem::path& folder() const { return folder_; }

  /// Nothing when another worker has it, or it is there already.
  std::optional<Claim> claim(const std::string& key);
  /// Runs being pressed by workers that are not known to be dead.
  int claimed() const { return claims_.count(); }

  struct Cost {
    double cpu_s = 0, wall_s = 0;
  };
  /// IoError leaves nothing half-written. A run that is there already stays as it is.
  void keep(const std::string& key, const press::Case&, const press::Result&, Cost) const;
  void forget(const std::string& key) const;
  /// Forgets the run if it is damaged: how. Empty where it is not, or another worker has claimed it.
  std::string forget_damaged(const std::string& key);
  Cost cost(const std::string& key) const;
  struct Glance {
    State state = State::missing;
    Cost cost = {};
  };
  /// State and cost, at the cost of one file where the run is there.
  Glance glance(const std::string& key) const;
  /// Why the run failed; empty for one that is done.
  std::string failure(const std::string& key) const;

  struct Merged {
    int copied = 0;
    std::vector<std::string> left_out; ///< runs, and why: damaged, or with another result than the one here
  };
  /// Opens for writing and copies runs that are not here yet, or damaged. InvalidInput, before anything is
  /// written, where one is no store, or has runs of an engine whose runs do not count here and are not to be
  /// kept.
  Merged merge(const std::vector<Store>& others, OldRuns);

 private:
  void sweep();
  std::string contradiction(const Store& other, const std::string& key) const;
  std::filesystem::path temporary(const std::string& key) const;
  bool publish(const std::filesystem::path& temporary, const std::string& key) const;

  std::filesystem::path folder_;
  std::string study_;
  std::vector<int> engines_;
  Claims claims_;
};

} // namespace platen::study
