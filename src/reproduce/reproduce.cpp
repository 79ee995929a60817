#include "reproduce/reproduce.hpp"

#include "core/catalogue.hpp"
#include "core/csv.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/output_folder.hpp"
#include "plot/press_folder.hpp"
#include "press/case_card.hpp"
#include "press/press.hpp"
#include "study/table.hpp"
#include "study/work.hpp"

#include <fmt/format.h>

#include <optional>

namespace platen::reproduce {
namespace {

namespace fs = std::filesystem;

using Say = std::function<void(const std::string&)>;

void show_or_stop(const Show& show, double share, const std::string& note) {
  if (!show("the page", share, note)) throw core::Interrupted("stopped as asked; the page is not whole");
}

/// Presses a pool again: DIR/pools/NAME with runs.csv and curves.csv, on the grid that the catalogue's has.
void press_pool(const Data& data, const std::string& name, const fs::path& folder, int workers,
                const Show& show) {
  const fs::path card = data.file("pools/" + name + "/study.toml");
  const auto study = study::read_study(card.string());
  study::Store store(folder / "store" / name, study.name);
  store.open_for_writing(study::OldRuns::recompute);
  study::work(study, store, workers, [&](const study::Tally& t) {
    (void)show("pool " + name, static_cast<double>(t.done + t.failed) / t.runs,
               fmt::format("{} of {} runs, {} failed", t.done + t.failed, t.runs, t.failed));
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
void press_alone(const fs::path& card, const fs::path& target, const Show& show, const Say& say) {
  const fs::path unfinished = target.string() + ".unfinished";
  const core::OutputFolder folder(unfinished);
  const auto c = press::read_case(card.string());
  const auto result = press::press(c, [&](double fraction, const press::CurvePoint& point) {
    return show("pressing " + c.material.name, fraction, fmt::format("delta_bar = {:.3f}", point.delta_bar));
  });
  if (result.interrupted) throw core::Interrupted("stopped as asked; the page is not whole");
  plot::write_press(c, result, folder, plot::Fields::pictures);
  if (result.failure) say("note: " + *result.failure);
  fs::rename(unfinished, target);
}

/// All that the papers rest on, pressed again; what is there already is kept.
void press_all(const Data& data, const std::vector<std::string>& papers, const fs::path& folder, int workers,
               const Show& show, const Say& say) {
  for (const auto& paper : papers) {
    const auto sources = sources_of(paper);
    for (const auto& name : sources.presses) {
      const fs::path target = folder / "papers/presses" / name;
      if (!fs::exists(target))
        press_alone(data.file("papers/presses/" + name + "/case.toml"), target, show, say);
    }
    for (const auto& name : sources.pools) press_pool(data, name, folder, workers, show);
  }
}

/// The numbers of the page that lies in the folder, else those that came with the program.
std::optional<fs::path> earlier_numbers(const Request& r, const Data& data) {
  if (!r.previous.empty()) return r.previous;
  if (fs::exists(r.folder / "numbers.csv")) return r.folder / "numbers.csv";
  try {
    return data.file("papers/numbers.csv");
  } catch (const core::InvalidInput&) { return {}; }
}

} // namespace

std::vector<Paper> reproduce(const Request& r, const Show& show, const Say& say) {
  std::vector<std::string> names = {r.paper};
  if (r.paper == "all") names = paper_names();
  for (const auto& name : names) sources_of(name); // refuses before any work
  const core::OutputFolder folder(r.folder);
  std::vector<fs::path> folders = core::catalogues();
  if (r.fresh) {
    const fs::path fresh = folder / "fresh";
    press_all(Data(folders), names, fresh, r.workers, show, say);
    folders.insert(folders.begin(), fresh);
  }
  const Data data(folders);
  std::optional<Earlier> earlier;
  if (const auto file = earlier_numbers(r, data)) earlier = read_numbers(*file);
  std::vector<Paper> papers;
  for (const auto& name : names) {
    show_or_stop(show, 0, name);
    papers.push_back(paper_rows(name, data));
  }
  write_page(papers, data, earlier, folder.path(),
             [&](double share) { show_or_stop(show, share, "figures"); });
  return papers;
}

std::string words_of(const std::vector<Paper>& papers) {
  std::string text = fmt::format("{:<14} {:>5} {:>11} {:>10} {:>15} {:>14}\n", "paper", "rows", "reproduced",
                                 "differing", "not comparable", "with a number");
  for (const auto& paper : papers) {
    const auto t = tally(paper.rows);
    text += fmt::format("{:<14} {:>5} {:>11} {:>10} {:>15} {:>14}\n", paper.name, t.rows, t.reproduced,
                        t.differing, t.not_comparable, t.with_number);
  }
  return text;
}

} // namespace platen::reproduce
