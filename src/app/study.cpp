#include "app/commands.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/progress.hpp"
#include "fit/edmans_sinka.hpp"
#include "study/table.hpp"
#include "study/work.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <thread>

namespace platen::app {
namespace {

struct Options {
  std::string card, store, output = "runs.csv", variant = "published";
  std::vector<std::string> others;
  int workers = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  bool retry_failed = false, recompute = false;
};

study::Store store_of(const study::Study& s, const Options& o) {
  return {o.store.empty() ? "out/" + s.name : o.store, s.name};
}

void print_tally(const study::Tally& t, const study::Store& store) {
  const int there = t.done + t.failed, left = t.runs - there;
  fmt::print("{} runs: {} done, {} failed, {} left; {:.0f} s CPU, {:.0f} s wall in presses; store {}\n",
             t.runs, t.done, t.failed, left, t.cpu_s, t.wall_s, store.folder().string());
  if (left > 0 && there > 0)
    fmt::print("about {:.0f} minutes of one worker left\n", t.wall_s / there * left / 60);
}

void status(const Options& o) {
  const auto s = study::read_study(o.card);
  const auto store = store_of(s, o);
  print_tally(study::tally(s, store), store);
  for (const auto& run : s.runs)
    if (const auto key = study::key_of(run.press_case); store.state(key) == study::Store::State::failed)
      fmt::print("failed {}: {}\n", key, store.failure(key));
}

void run(const Options& o) {
  const auto s = study::read_study(o.card);
  const auto store = store_of(s, o);
  store.open_for_writing(o.recompute);
  if (o.retry_failed)
    for (const auto& one : s.runs)
      if (const auto key = study::key_of(one.press_case); store.state(key) == study::Store::State::failed)
        store.forget(key);
  {
    core::Progress progress("study " + s.name);
    study::work(s, store, o.workers, [&](const study::Tally& t) {
      progress.show(static_cast<double>(t.done + t.failed) / t.runs,
                    fmt::format("{} of {} runs, {} failed", t.done + t.failed, t.runs, t.failed));
    });
  }
  const auto t = study::tally(s, store);
  print_tally(t, store);
  if (t.done == 0 && t.failed > 0)
    throw core::ConvergenceError("every press of the study failed; `platen study status` gives the reasons",
                                 0, 0, 0);
}

void export_table(const Options& o) {
  const auto s = study::read_study(o.card);
  core::write_file(o.output, study::runs_csv(s, store_of(s, o), o.variant));
}

void merge(const Options& o) {
  const auto s = study::read_study(o.card);
  const auto store = store_of(s, o);
  store.open_for_writing(o.recompute);
  int copied = 0;
  for (const auto& other : o.others) copied += store.merge({other, s.name});
  fmt::print("{} runs copied to {}\n", copied, store.folder().string());
}

} // namespace

void add_study(CLI::App& program) {
  auto* command = program.add_subcommand("study", "many presses: run, status, export, merge");
  command->require_subcommand(1);
  auto o = std::make_shared<Options>();
  const auto add = [&](const char* name, const char* what, void (*action)(const Options&)) {
    auto* sub = command->add_subcommand(name, what);
    sub->add_option("STUDY.toml", o->card, "the study card")->required();
    sub->add_option("--store", o->store, "folder of the runs; default out/NAME")->type_name("DIR");
    sub->callback([o, action] { action(*o); });
    return sub;
  };
  auto* start = add("run", "press what is missing; the same command goes on after a stop", run);
  start->add_option("--workers", o->workers, "processes")->check(CLI::Range(1, 1024))->capture_default_str();
  start->add_flag("--retry-failed", o->retry_failed, "press failed runs again");
  start->add_flag("--recompute", o->recompute, "press again what another engine computed");
  start->footer("Example: platen study run examples/study.toml --store out/study --workers 2");
  add("status", "what is done, what failed and why, what is left", status);
  auto* table = add("export", "fit the kept curves and write one table, without a press", export_table);
  table->add_option("-o", o->output, "the table")->type_name("FILE")->capture_default_str();
  table->add_option("--variant", o->variant, "form of the law: published, c1, hertz-like")
      ->capture_default_str();
  auto* join = add("merge", "copy runs of other stores into this one", merge);
  join->add_option("--from", o->others, "the other stores")->required()->type_name("DIR");
  command->footer("Example: platen study run examples/study.toml");
}

} // namespace platen::app
