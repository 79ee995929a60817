#pragma once
// What studies and pools share.

#include "core.hpp"

#include "study/card.hpp"
#include "study/sheet.hpp"
#include "study/store.hpp"
#include "study/work.hpp"

namespace platen::python {

/// A study and the folder of its runs.
struct Study {
  study::Study study;
  std::filesystem::path folder;

  study::Store store() const { return {folder, study.name}; }
};

/// Columns by their names: numbers as arrays, empty cells not-a-number; words as lists.
nb::list columns_of(const study::Sheet&);

/// How many processes press: 0 is one a processor. InvalidInput.
int processes(int workers);

/// A function of Python that is called with the runs done, failed, and all.
inline auto counting(Callback& callback) {
  return [&callback](const study::Tally& t) { callback(t.done, t.failed, t.runs); };
}

/// Long work that calls `callback`: what that raised goes on when the work has ended.
template <class Work> auto watched(const Callback& callback, Work work) {
  try {
    auto result = long_work(work);
    callback.rethrow();
    return result;
  } catch (const core::Interrupted&) {
    callback.rethrow();
    throw;
  }
}

} // namespace platen::python
