#pragma once
// A data pool beside presses of today.

#include "study/pool.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace platen::study {

/// Which runs are pressed again, and how far.
struct CheckOptions {
  double share = 0.05;    ///< of all, at random
  std::uint64_t seed = 1; ///< which of them
  bool cheapest = false;  ///< instead: two_cheap()
  double until = 0;       ///< as recompute()
  int workers = 1;        ///< processes
};

struct Check {
  std::string pool, engine; ///< folder, and what pressed it
  double tolerance = 0;
  std::vector<Comparison> runs;

  bool same(const Comparison& c) const { return c.difference && *c.difference <= tolerance; }
};

/// InvalidInput where no run of the pool is done. Interrupted, IoError.
Check check(const Pool&, const CheckOptions&, const std::function<void(const Tally&)>& show);

/// A line for each run.
std::string words_of(const Check&);
/// InvalidInput where runs differ by more than the tolerance.
void refuse_different(const Check&);

} // namespace platen::study
