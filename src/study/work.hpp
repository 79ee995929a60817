#pragma once
// Pressing what is missing: processes that claim runs from the store.

#include "study/card.hpp"
#include "study/store.hpp"

#include <functional>

namespace platen::study {

struct Tally {
  int runs = 0, done = 0, failed = 0;
  double cpu_s = 0, wall_s = 0; ///< of the runs that are there, summed
};
Tally tally(const Study&, const Store&);

/// Presses until every run is there; waits for those that live workers elsewhere have claimed. Throws
/// core::Interrupted, core::IoError; a press that fails is
/// kept with its reason.
void work(const Study&, const Store&);

/// The same in `workers` processes; `show` is called now and then. Throws what stopped a worker: Interrupted
/// when the user asked, IoError when the store could not be written or a worker died.
void work(const Study&, const Store&, int workers, const std::function<void(const Tally&)>& show);

} // namespace platen::study
