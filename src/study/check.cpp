#include "study/check.hpp"

#include "core/error.hpp"
#include "core/version.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace platen::study {

Check check(const Pool& pool, const CheckOptions& o, const std::function<void(const Tally&)>& show) {
  const auto runs = o.cheapest ? two_cheap(pool) : sample(pool, o.share, o.seed);
  if (runs.empty())
    throw core::InvalidInput(fmt::format("{}: no run of the pool is done", pool.folder.string()));
  return {pool.folder.string(), pool.engine, tolerance(pool),
          recompute(pool, runs, o.until, o.workers, show)};
}

std::string words_of(const Check& c) {
  std::string text;
  if (c.engine != std::to_string(core::engine))
    text += fmt::format("the pool was pressed by engine {}, this is engine {}: runs are the same within {}\n",
                        c.engine, core::engine, c.tolerance);
  for (const auto& one : c.runs)
    text += fmt::format("run {:>4}: {}\n", one.run + 1,
                        one.difference ? fmt::format("{}, largest difference {:.2g}",
                                                     c.same(one) ? "as before" : "DIFFERENT", *one.difference)
                                       : "DIFFERENT: " + one.reason);
  return text;
}

void refuse_different(const Check& c) {
  const auto different = std::ranges::count_if(c.runs, [&](const auto& one) { return !c.same(one); });
  if (different > 0)
    throw core::InvalidInput(
        fmt::format("{}: {} of {} runs differ from the pool by more than {}; where the press was "
                    "meant to change, raise the engine number and compute the pool again",
                    c.pool, different, c.runs.size(), c.tolerance));
}

} // namespace platen::study
