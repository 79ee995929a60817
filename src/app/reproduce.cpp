#include "app/commands.hpp"
#include "app/output_folder.hpp"
#include "app/press_into.hpp"
#include "core/catalogue.hpp"
#include "core/csv.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/progress.hpp"
#include "core/say.hpp"
#include "press/case_card.hpp"
#include "reproduce/page.hpp"
#include "study/table.hpp"
#include "study/work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

namespace platen::app {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string paper, folder = "out/papers", previous;
  bool fresh = false;
  int workers = 1;
};

/// Presses a pool again: DIR/pools/NAME with runs.csv and curves.csv, on the grid that the catalogue's has.
void press_pool(const reproduce::Data& data, const std::string& name, const fs::path& folder, int workers) {
  const fs::path card = data.file("pools/" + name + "/study.toml");
  const auto study = study::read_study(card.string());
  study::Store store(folder / "store" / name, study.name);
  store.open_for_writing(study::OldRuns::recompute);
  core::Progress progress("pool " + name);
  study::work(study, store, workers, [&](const study::Tally& t) {
    progress.show(static_cast<double>(t.done + t.failed) / t.runs,
                  fmt::format("{} of {} runs", t.done + t.failed, t.runs));
  });
  const fs::path target = folder / "pools" / name;
  core::prepare_folder(target);
  const double step = core::read_csv(card.parent_path() / "curves.csv").number_note("step");
  const auto found = study::find_runs(study, store);
  core::write_file(target / "runs.csv", study::csv_text(study::runs_sheet(study, store, found, "published")));
  core::write_file(target / "curves.csv", study::csv_text(study::curves_sheet(study, store, found, step)));
}

/// One press again; the folder has its name only when it is whole. One that comes to its limit load early is
/// kept as far as it went.
void press_alone(const fs::path& card, const fs::path& target) {
  const fs::path unfinished = target.string() + ".unfinished";
  core::prepare_folder(unfinished);
  try {
    press_into(press::read_case(card.string()), OutputFolder(unfinished), Fields::pictures);
  } catch (const core::ConvergenceError& early) { core::say(fmt::format("note: {}\n", early.what())); }
  fs::rename(unfinished, target);
}

/// All that the papers rest on, pressed again; what is there already is kept.
void press_all(const reproduce::Data& data, const std::vector<std::string>& papers, const fs::path& folder,
               int workers) {
  for (const auto& paper : papers) {
    const auto sources = reproduce::sources_of(paper);
    for (const auto& name : sources.presses) {
      const fs::path target = folder / "papers/presses" / name;
      if (!fs::exists(target)) press_alone(data.file("papers/presses/" + name + "/case.toml"), target);
    }
    for (const auto& name : sources.pools) press_pool(data, name, folder, workers);
  }
}

/// The numbers of the page that lies in the folder, else those that came with the program.
std::optional<fs::path> earlier_numbers(const Options& o, const reproduce::Data& data) {
  if (!o.previous.empty()) return o.previous;
  if (fs::exists(fs::path(o.folder) / "numbers.csv")) return fs::path(o.folder) / "numbers.csv";
  try {
    return data.file("papers/numbers.csv");
  } catch (const core::InvalidInput&) { return {}; }
}

void reproduce_papers(const Options& o) {
  std::vector<std::string> names = {o.paper};
  if (o.paper == "all") names = reproduce::paper_names();
  for (const auto& name : names) reproduce::sources_of(name); // refuses before any work
  const OutputFolder folder(o.folder);
  std::vector<fs::path> folders = core::catalogues();
  if (o.fresh) {
    const fs::path fresh = folder / "fresh";
    press_all(reproduce::Data(folders), names, fresh, o.workers);
    folders.insert(folders.begin(), fresh);
  }
  const reproduce::Data data(folders);
  std::optional<reproduce::Earlier> earlier;
  if (const auto file = earlier_numbers(o, data)) earlier = reproduce::read_numbers(*file);
  std::vector<reproduce::Paper> papers;
  core::Progress progress("reproducing " + o.paper);
  for (const auto& name : names) {
    progress.show(0, name);
    papers.push_back(reproduce::paper_rows(name, data));
  }
  reproduce::write_page(papers, data, earlier, folder.path(),
                        [&](double share) { progress.show(share, "figures"); });
  fmt::print("{:<14} {:>5} {:>11} {:>10} {:>15} {:>14}\n", "paper", "rows", "reproduced", "differing",
             "not comparable", "with a number");
  for (const auto& paper : papers) {
    const auto t = reproduce::tally(paper.rows);
    fmt::print("{:<14} {:>5} {:>11} {:>10} {:>15} {:>14}\n", paper.name, t.rows, t.reproduced, t.differing,
               t.not_comparable, t.with_number);
  }
  fmt::print("page in {}\n", (folder / "index.html").string());
}

} // namespace

void add_reproduce(Command program) {
  auto command =
      program.add_subcommand("reproduce", "the papers' figures and tables beside ours, on one page");
  auto o = std::make_shared<Options>();
  command.add_option("PAPER", o->paper, "edmans-sinka, wang, shahin, or all").required();
  command.add_option("-o", o->folder, "folder for the page").type_name("DIR").capture_default_str();
  command.add_flag(
      "--fresh", o->fresh,
      "press everything again instead of reading the catalogue's pools; hours, resumed where it stopped");
  command.add_option("--workers", o->workers, "processes that press, with --fresh")
      .range(1, 256)
      .capture_default_str();
  command
      .add_option("--previous", o->previous,
                  "numbers.csv of an earlier page; by default the one in DIR, else the catalogue's")
      .type_name("FILE");
  command.footer("What changed against the earlier numbers by more than its error is marked.\n"
                 "Example: platen reproduce all -o out/papers");
  command.callback([o] { reproduce_papers(*o); });
}

} // namespace platen::app
