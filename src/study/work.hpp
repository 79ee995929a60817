#pragma once
// Pressing what is missing: processes that claim runs from the store.

#include "press/press.hpp"
#include "study/card.hpp"
#include "study/store.hpp"

#include <functional>
#include <string>
#include <vector>

namespace platen::study {

struct Tally {
  int runs = 0, done = 0, failed = 0;
  double cpu_s = 0, wall_s = 0;      ///< of the runs that are there, summed
  std::vector<std::string> failures; ///< their keys
};

/// Counts the runs of a study; looks again only for those that were missing.
class Census {
 public:
  Census(const Study&, const Store&);
  const Tally& take();

 private:
  const Store& store_;
  std::vector<std::string> missing_;
  Tally tally_;
};
Tally tally(const Study&, const Store&);

/// ConvergenceError where every press failed.
void refuse_total_failure(const Study&, const Store&, const Tally&);

/// Forgets the runs whose content is not what was written; a sentence for each.
std::vector<std::string> forget_damaged(const Study&, Store&);

/// What presses: press::press, or something quick in its place.
using Press = std::function<press::Result(const press::Case&, const press::Progress&)>;

/// Presses until every run is there; waits for those that live workers elsewhere have claimed. Throws
/// core::Interrupted, core::IoError; a press that fails is kept with its reason.
void work(const Study&, Store&, const Press& = press::press);

/// The same in `workers` processes; `show` is called now and then. Throws what stopped a worker: Interrupted
/// when the user asked, IoError when the store could not be written or a worker died.
void work(const Study&, Store&, int workers, const std::function<void(const Tally&)>& show,
          const Press& = press::press);

} // namespace platen::study
