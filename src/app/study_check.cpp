#include "app/study_check.hpp"

#include "core/parallel.hpp"
#include "core/progress.hpp"
#include "study/check.hpp"

#include <fmt/format.h>

#include <memory>
#include <optional>

namespace platen::app {
namespace {

struct Options {
  std::string pool;
  int seed = 1;
  study::CheckOptions how = {.workers = core::processors()};
};

void check(Options o) {
  o.how.seed = static_cast<std::uint64_t>(o.seed);
  const auto pool = study::read_pool(o.pool);
  std::optional<core::Progress> progress("pool " + pool.study.name);
  const auto found = study::check(pool, o.how, [&](const study::Tally& t) {
    progress->show(static_cast<double>(t.done + t.failed) / t.runs,
                   fmt::format("{} of {} runs", t.done + t.failed, t.runs));
  });
  progress.reset(); // its line ends before what is found
  fmt::print("{}", words_of(found));
  study::refuse_different(found);
}

} // namespace

void add_study_check(Command study) {
  auto o = std::make_shared<Options>();
  auto command = study.add_subcommand("check", "press runs of a data pool again and compare");
  command.add_option("POOL", o->pool, "folder with study.toml, runs.csv, curves.csv")
      .required()
      .type_name("DIR");
  command.add_option("--share", o->how.share, "of the runs, at random").range(0.0, 1.0).capture_default_str();
  command.add_option("--seed", o->seed, "which of them").range(0, 1000000000).capture_default_str();
  command.add_flag("--cheapest", o->how.cheapest,
                   "instead: two, of the softer and of the stiffer half the run that took least time");
  command
      .add_option("--until", o->how.until,
                  "press only to this delta/R0, without unloading (not local, triaxial)")
      .range(1e-4, 1.0);
  command.add_option("--workers", o->how.workers, "processes").range(1, 1024).capture_default_str();
  command.footer("Example: platen study check catalogue/pools/edmans-sinka --share 0.02");
  command.callback([o] { check(*o); });
}

} // namespace platen::app
