#include "app/study_check.hpp"

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "core/progress.hpp"
#include "core/version.hpp"
#include "study/pool.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace platen::app {
namespace {

struct Options {
  std::string pool;
  bool cheapest = false;
  int seed = 1, workers = core::processors();
  double share = 0.05, until = 0;
};

void check(const Options& o) {
  const auto pool = study::read_pool(o.pool);
  const auto runs =
      o.cheapest ? study::two_cheap(pool) : study::sample(pool, o.share, static_cast<std::uint64_t>(o.seed));
  if (runs.empty()) throw core::InvalidInput(fmt::format("{}: no run of the pool is done", o.pool));
  std::vector<study::Comparison> comparisons;
  {
    core::Progress progress("pool " + pool.study.name);
    comparisons = study::recompute(pool, runs, o.until, o.workers, [&](const study::Tally& t) {
      progress.show(static_cast<double>(t.done + t.failed) / t.runs,
                    fmt::format("{} of {} runs", t.done + t.failed, t.runs));
    });
  }
  const double tolerance = study::tolerance(pool);
  if (pool.engine != std::to_string(core::engine))
    fmt::print("the pool was pressed by engine {}, this is engine {}: runs are the same within {}\n",
               pool.engine, core::engine, tolerance);
  int different = 0;
  for (const auto& c : comparisons) {
    const bool good = c.difference && *c.difference <= tolerance;
    different += !good;
    fmt::print("run {:>4}: {}\n", c.run + 1,
               c.difference ? fmt::format("{}, largest difference {:.2g}", good ? "as before" : "DIFFERENT",
                                          *c.difference)
                            : "DIFFERENT: " + c.reason);
  }
  if (different > 0)
    throw core::InvalidInput(
        fmt::format("{}: {} of {} runs differ from the pool by more than {}; where the press was "
                    "meant to change, raise the engine number and compute the pool again",
                    o.pool, different, comparisons.size(), tolerance));
}

} // namespace

void add_study_check(Command study) {
  auto o = std::make_shared<Options>();
  auto command = study.add_subcommand("check", "press runs of a data pool again and compare");
  command.add_option("POOL", o->pool, "folder with study.toml, runs.csv, curves.csv")
      .required()
      .type_name("DIR");
  command.add_option("--share", o->share, "of the runs, at random").range(0.0, 1.0).capture_default_str();
  command.add_option("--seed", o->seed, "which of them").range(0, 1000000000).capture_default_str();
  command.add_flag("--cheapest", o->cheapest,
                   "instead: two, of the softer and of the stiffer half the run that took least time");
  command
      .add_option("--until", o->until, "press only to this delta/R0, without unloading (not local, triaxial)")
      .range(1e-4, 1.0);
  command.add_option("--workers", o->workers, "processes").range(1, 1024).capture_default_str();
  command.footer("Example: platen study check catalogue/pools/edmans-sinka --share 0.02");
  command.callback([o] { check(*o); });
}

} // namespace platen::app
