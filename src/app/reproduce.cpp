#include "reproduce/reproduce.hpp"
#include "app/commands.hpp"
#include "core/interrupt.hpp"
#include "core/progress.hpp"
#include "core/say.hpp"

#include <fmt/format.h>

#include <memory>
#include <optional>

namespace platen::app {
namespace {

struct Options {
  std::string paper, folder = "out/papers", previous;
  bool fresh = false;
  int workers = 1;
};

/// A bar for each stage.
class Stages {
 public:
  void show(const std::string& stage, double share, const std::string& note) {
    if (stage != stage_) bar_.emplace(stage);
    stage_ = stage;
    bar_->show(share, note);
  }

 private:
  std::string stage_;
  std::optional<core::Progress> bar_;
};

void reproduce_papers(const Options& o) {
  std::optional<Stages> stages(std::in_place);
  const auto papers = reproduce::reproduce(
      {o.paper, o.folder, o.fresh, o.workers, o.previous},
      [&](const std::string& stage, double share, const std::string& note) {
        stages->show(stage, share, note);
        return !core::interrupted();
      },
      core::say_line);
  stages.reset(); // its line ends before the table
  fmt::print("{}page in {}\n", words_of(papers), (std::filesystem::path(o.folder) / "index.html").string());
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
