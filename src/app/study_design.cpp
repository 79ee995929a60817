#include "app/study_design.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "study/card.hpp"
#include "study/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace platen::app {
namespace {

struct Options {
  std::string card, output, beside;
  bool keys = false;
};

/// The points of `other` with the factors in the order of `s`.
std::vector<study::Point> reordered(const study::Study& other, const study::Study& s) {
  std::vector<std::size_t> order;
  for (const auto& factor : s.factors) {
    const auto found = std::find_if(other.factors.begin(), other.factors.end(),
                                    [&](const study::Factor& f) { return f.name == factor.name; });
    if (found == other.factors.end())
      throw core::InvalidInput(
          fmt::format("{}: there is no factor '{}', which {} has; designs are compared over "
                      "the same factors",
                      other.file, factor.name, s.file));
    order.push_back(static_cast<std::size_t>(found - other.factors.begin()));
  }
  std::vector<study::Point> points;
  for (const auto& run : other.runs) {
    points.emplace_back();
    for (const auto i : order) points.back().push_back(run.inputs[i]);
  }
  return points;
}

void print_line(const study::Study& s, const study::Study& ranges, const std::vector<study::Point>& points) {
  const auto cube = study::in_cube(ranges.factors, study::points_of(ranges), points);
  const auto spread = study::spread(cube, study::categories(points));
  fmt::print("{:<24} {:>5}  {:<16} {:>10.4g} {:>16.4g} {:>10.4g}\n", s.name, points.size(), s.kind,
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
  print_line(s, s, study::points_of(s));
  if (!o.beside.empty()) {
    const auto other = study::read_study(o.beside);
    print_line(other, s, reordered(other, s));
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
