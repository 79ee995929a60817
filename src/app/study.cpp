#include "app/commands.hpp"
#include "app/study_check.hpp"
#include "app/study_design.hpp"
#include "app/study_methods.hpp"
#include "app/study_refine.hpp"
#include "app/study_sobol.hpp"
#include "app/study_surrogate.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/parallel.hpp"
#include "core/progress.hpp"
#include "core/say.hpp"
#include "study/submit.hpp"
#include "study/table.hpp"
#include "study/work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

namespace platen::app {
namespace {

struct Options {
  std::string card, store, output = "runs.csv", curves, variant = "published";
  std::vector<std::string> others, slurm;
  int workers = core::processors(), tasks = 16;
  double step = 0.01;
  bool retry_failed = false, keep = false, recompute = false, dry_run = false;

  study::OldRuns old() const {
    return recompute ? study::OldRuns::recompute : keep ? study::OldRuns::keep : study::OldRuns::ask;
  }
};

study::Store store_of(const study::Study& s, const Options& o) {
  return {o.store.empty() ? "out/" + s.name : o.store, s.name};
}

void print_tally(const study::Tally& t, const study::Store& store) {
  if (!std::filesystem::exists(store.folder()))
    core::say_line(fmt::format("note: there is no folder {} yet", store.folder().string()));
  const int there = t.done + t.failed, left = t.runs - there, claimed = store.claimed();
  fmt::print("{} runs: {} done, {} failed, {} left; {:.0f} s CPU, {:.0f} s wall in presses; store {}\n",
             t.runs, t.done, t.failed, left, t.cpu_s, t.wall_s, store.folder().string());
  if (claimed > 0) fmt::print("{} being pressed\n", claimed);
  if (left > 0 && there > 0) {
    const double minutes = t.wall_s / there * left / 60;
    fmt::print("about {:.3g} minutes of one worker left", minutes);
    if (claimed > 1) fmt::print(", {:.3g} with the {} at work", minutes / claimed, claimed);
    fmt::print("\n");
  }
}

void status(const Options& o) {
  const auto s = study::read_study(o.card);
  const auto store = store_of(s, o);
  const auto t = study::tally(s, store);
  print_tally(t, store);
  for (const auto& key : t.failures) fmt::print("failed {}: {}\n", key, store.failure(key));
}

void run(const Options& o) {
  const auto s = study::read_study(o.card);
  auto store = store_of(s, o);
  store.open_for_writing(o.old());
  for (const auto& what : study::forget_damaged(s, store)) core::say_line("note: " + what);
  if (o.retry_failed)
    for (const auto& key : study::tally(s, store).failures) store.forget(key);
  {
    core::Progress progress("study " + s.name);
    study::work(s, store, o.workers, [&](const study::Tally& t) {
      progress.show(static_cast<double>(t.done + t.failed) / t.runs,
                    fmt::format("{} of {} runs, {} failed", t.done + t.failed, t.runs, t.failed));
    });
  }
  const auto t = study::tally(s, store);
  print_tally(t, store);
  study::refuse_total_failure(s, store, t);
  if (t.failed > 0)
    core::say(
        fmt::format("note: {} of {} presses failed: `platen study status` gives the reasons, --retry-failed "
                    "presses them again\n",
                    t.failed, t.runs));
}

void export_table(const Options& o) {
  const auto s = study::read_study(o.card);
  const auto store = store_of(s, o);
  const auto found = study::find_runs(s, store);
  if (const auto what = study::nothing_done(store, found); !what.empty()) core::say_line("note: " + what);
  const auto runs = study::runs_sheet(s, store, found, o.variant);
  const auto curves = [&] { return study::curves_sheet(s, store, found, o.step); };
  if (study::is_sqlite(o.output)) study::write_sqlite(o.output, {runs, curves()});
  else core::write_file(o.output, study::csv_text(runs));
  if (!o.curves.empty()) core::write_file(o.curves, study::csv_text(curves()));
  if (const auto what = study::damage(store, found); !what.empty()) throw core::IoError(what);
}

void merge(const Options& o) {
  const auto s = study::read_study(o.card);
  auto store = store_of(s, o);
  std::vector<study::Store> others;
  for (const auto& other : o.others) others.emplace_back(other, s.name);
  const auto merged = store.merge(others, o.old());
  for (const auto& what : merged.left_out) core::say(fmt::format("note: {}; the run was left out\n", what));
  fmt::print("{} runs copied to {}\n", merged.copied, store.folder().string());
}

void submit(const Options& o) {
  const auto s = study::read_study(o.card);
  auto store = store_of(s, o);
  const study::Job job{
      study::worker_of(std::filesystem::read_symlink("/proc/self/exe"), o.card, store.folder()), o.tasks,
      o.slurm};
  if (o.dry_run) {
    fmt::print("{}", study::batch_script(s, store, job));
    return;
  }
  const auto answer = study::submit(s, store, job, o.old());
  if (answer.empty()) fmt::print("nothing is left to press in {}\n", store.folder().string());
  else fmt::print("{}\n", answer);
}

} // namespace

void add_study(Command program) {
  auto command =
      program.add_subcommand("study", "many presses: design, run, status, export, submit, merge, check");
  command.require_subcommand();
  auto o = std::make_shared<Options>();
  const auto add = [&](const char* name, const char* what, void (*action)(const Options&)) {
    auto sub = command.add_subcommand(name, what);
    sub.add_option("STUDY.toml", o->card, "the study card").required();
    sub.add_option("--store", o->store, "folder of the runs; default out/NAME").type_name("DIR");
    sub.callback([o, action] { action(*o); });
    return sub;
  };
  const auto add_old = [&](Command sub) {
    auto keep = sub.add_flag("--keep", o->keep, "count the runs of another engine, press what is missing");
    sub.add_flag("--recompute", o->recompute, "press again what another engine computed").excludes(keep);
  };
  add_study_design(command);
  auto start = add("run", "press what is missing; the same command goes on after a stop", run);
  start.add_option("--workers", o->workers, "processes").range(1, 1024).capture_default_str();
  start.add_flag("--retry-failed", o->retry_failed, "press failed runs again");
  add_old(start);
  start.footer("Example: platen study run examples/study.toml --store out/study --workers 2");
  add("status", "what is done, what failed and why, what is left", status)
      .footer("Example: platen study status examples/study.toml --store out/study");
  auto table = add("export", "fit the kept curves and write tables, without a press", export_table);
  table.add_option("-o", o->output, "the runs: CSV, or SQLite with the curves where it ends in .sqlite")
      .type_name("FILE")
      .capture_default_str();
  table.add_option("--curves", o->curves, "the curves on a common grid, as CSV").type_name("FILE");
  table.add_option("--step", o->step, "grid of the loading branches in delta/R0")
      .range(1e-5, 0.5)
      .capture_default_str();
  table.add_option("--variant", o->variant, "form of the law: published, c1, hertz-like")
      .capture_default_str();
  table.footer(
      "Example: platen study export examples/study.toml --store out/study -o runs.csv --curves curves.csv\n"
      "         platen study export examples/study.toml --store out/study -o study.sqlite");
  auto job = add("submit", "a Slurm job array whose tasks press what is missing", submit);
  job.add_option("--tasks", o->tasks, "tasks of the array; not more than runs are left")
      .range(1, 10000)
      .capture_default_str();
  job.add_option("--slurm", o->slurm, "an option of sbatch; may be repeated").type_name("OPTION");
  job.add_flag("--dry-run", o->dry_run, "print the batch script and submit nothing");
  add_old(job);
  job.footer("Example: platen study submit examples/study.toml --store /shared/study --tasks 32 "
             "--slurm=--time=4:00:00 --slurm=--partition=short\n"
             "The store and the card must be in a folder that all nodes see.");
  auto join = add("merge", "copy runs of other stores into this one", merge);
  join.add_option("--from", o->others, "the other stores").required().type_name("DIR");
  join.add_flag("--keep", o->keep, "count the runs of another engine");
  join.footer("Example: platen study merge examples/study.toml --store out/all --from out/mine out/theirs");
  add_study_check(command);
  add_study_surrogate(command);
  add_study_methods(command);
  add_study_refine(command);
  add_study_sobol(command);
  command.footer("Example: platen study run examples/study.toml");
}

} // namespace platen::app
