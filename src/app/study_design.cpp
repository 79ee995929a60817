#include "app/study_design.hpp"

#include "core/file.hpp"
#include "study/card.hpp"
#include "study/filling.hpp"
#include "study/table.hpp"

#include <fmt/format.h>

#include <memory>

namespace platen::app {
namespace {

struct Options {
  std::string card, output, beside;
  bool keys = false;
};

void print_line(const study::Study& s, const study::Spread& spread) {
  fmt::print("{:<24} {:>5}  {:<16} {:>10.4g} {:>16.4g} {:>10.4g}\n", s.name, s.runs.size(), s.kind,
             spread.min_distance, spread.min_distance_within, spread.maxpro);
}

void design(const Options& o) {
  if (o.keys) {
    fmt::print("{}", study::study_reference());
    return;
  }
  const auto s = study::read_study(o.card);
  fmt::print("{:<24} {:>5}  {:<16} {:>10} {:>16} {:>10}\n", "design", "runs", "kind", "min. dist.",
             "of one category", "MaxPro");
  print_line(s, study::spread_of(s));
  if (!o.beside.empty()) {
    const auto other = study::read_study(o.beside);
    print_line(other, study::spread_of(other, s));
  }
  fmt::print(
      "distances in the unit cube of the ranges of {}; MaxPro: small is good, inf where two runs share a "
      "number\n",
      s.name);
  if (!o.output.empty()) core::write_file(o.output, study::csv_text(study::design_sheet(s)));
}

} // namespace

void add_study_design(Command study) {
  auto o = std::make_shared<Options>();
  auto command = study.add_subcommand("design", "the runs of a study, and how well they fill their ranges");
  auto card = command.add_option("STUDY.toml", o->card, "the study card");
  command.add_option("-o", o->output, "the runs as CSV").type_name("FILE");
  command.add_option("--beside", o->beside, "a study over the same factors, to compare with")
      .type_name("STUDY.toml");
  command.footer(
      "Example: platen study design examples/space-filling.toml --beside examples/shahin-a1.toml -o "
      "design.csv");
  command.add_flag("--keys", o->keys, "every key of a study card, as Markdown").excludes(card);
  command.callback([o] {
    if (o->card.empty() && !o->keys) refuse_missing("STUDY.toml");
    design(*o);
  });
}

} // namespace platen::app
