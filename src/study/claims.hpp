#pragma once
// Which worker presses which run. A claim is a file, claims/KEY, that a worker makes exclusively and in which
// it counts on while it lives. Whoever waits times that by its own monotonic clock: a count that stands still
// for long enough belongs to a dead worker, wherever it ran. Neither clocks, host names, locks nor links take
// part. Where processes can be looked up (same boot, same name space of processes) a dead owner is seen at
// once.
//
// A claim saves work, it does not guard results: two workers that press one run both get the same, and the
// first to publish it wins (store.hpp).

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace platen::study {

struct Pace {
  std::chrono::milliseconds beat{10'000};     ///< between two counts of an owner
  std::chrono::milliseconds silence{120'000}; ///< after which others believe it dead
};

/// The right to press one run; given back when it goes out of scope.
class Claim {
 public:
  Claim(std::filesystem::path file, std::string owner, Pace);
  Claim(Claim&&) noexcept;
  Claim& operator=(Claim&&) = delete;
  ~Claim();

 private:
  struct Heart;
  std::unique_ptr<Heart> heart_;
};

class Claims {
 public:
  explicit Claims(std::filesystem::path folder, Pace pace = {}) : folder_(std::move(folder)), pace_(pace) {}

  /// Nothing when another worker has it. IoError where no claim can be made.
  std::optional<Claim> take(const std::string& key);

  /// Whether somebody has claimed it, dead or alive.
  bool has(const std::string& key) const { return std::filesystem::exists(folder_ / key); }

  /// Claims of workers that are not known to be dead.
  int count() const;

 private:
  bool stands_still(const std::string& name, const std::string& content);
  void remove_dead(const std::string& key, const std::string& content);

  struct Seen {
    std::string content;
    std::chrono::steady_clock::time_point since;
  };
  std::filesystem::path folder_;
  Pace pace_;
  std::map<std::string, Seen> seen_; ///< claims of others, and since when they stand still
};

} // namespace platen::study
