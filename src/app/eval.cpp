#include "app/commands.hpp"
#include "app/law_arguments.hpp"
#include "core/csv.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/number.hpp"
#include "core/say.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <memory>

namespace platen::app {
namespace {

struct Options {
  LawArguments law;
  std::string partner, overlap, path, output;
  bool exact = false, json = false;
};

constexpr const char* branch_names[] = {"separated", "loading", "unloading", "reloading"};

struct Row {
  double overlap;
  law::Response response;
};

std::vector<double> asked_overlaps(const Options& options) {
  if (options.overlap.empty() == options.path.empty())
    throw core::InvalidInput("give either --overlap FROM:TO:COUNT (or one overlap) or --path FILE");
  if (!options.overlap.empty()) return overlaps_of(options.overlap);
  const auto csv = core::read_csv(options.path);
  const auto column = csv.column("overlap_m");
  std::vector<double> overlaps;
  for (const auto& row : csv.rows) overlaps.push_back(csv.number(row, column));
  if (overlaps.empty()) throw core::InvalidInput(options.path + ": there is no row below the header");
  return overlaps;
}

std::string csv_of(const std::vector<Row>& rows) {
  std::string text = "overlap_m,force_N,contact_radius_m,mean_pressure_Pa,stiffness_N_per_m,branch,"
                     "dissipated_work_J,in_range\n";
  for (const auto& [overlap, r] : rows)
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{}\n", core::number_text(overlap),
                   core::number_text(r.force), core::number_text(r.contact_radius),
                   core::number_text(r.mean_pressure), core::number_text(r.stiffness),
                   branch_names[static_cast<int>(r.branch)], core::number_text(r.dissipated_work),
                   r.in_range ? "true" : "false");
  return text;
}

std::string json_of(const fit::LawCard& card, const std::vector<Row>& rows) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& [overlap, r] : rows)
    list.push_back({{"overlap_m", overlap},
                    {"force_N", r.force},
                    {"contact_radius_m", r.contact_radius},
                    {"mean_pressure_Pa", r.mean_pressure},
                    {"stiffness_N_per_m", r.stiffness},
                    {"branch", branch_names[static_cast<int>(r.branch)]},
                    {"dissipated_work_J", r.dissipated_work},
                    {"in_range", r.in_range}});
  return nlohmann::ordered_json{{"law", card.law}, {"variant", card.variant}, {"points", list}}.dump(2) +
         "\n";
}

/// The law that is asked, and where its cards hold.
struct Asked {
  law::Law law;
  fit::Validity validity;
};
Asked asked_law(const fit::LawCard& card, const Options& options) {
  const law::ParameterTexts more = parameters_of(options.law);
  if (options.partner.empty()) {
    law::Law law = fit::make_law(card, more);
    return {law, fit::validity_of(card, law)};
  }
  for (const auto& [key, value] : more)
    if (key != "radius_m" && key != "radius2_m")
      throw core::InvalidInput(
          fmt::format("{} has no place beside --with: its cards say all but radius_m and radius2_m", key));
  const fit::LawCard partner = fit::find_law_card(options.partner);
  law::Law law = fit::make_law(card, partner, more);
  return {law, fit::common(fit::validity_of(card, law), fit::validity_of(partner, law))};
}

void eval(const Options& options) {
  const fit::LawCard card = card_of(options.law);
  const auto [law, validity] = asked_law(card, options);
  std::vector<Row> rows;
  law::State state;
  std::size_t outside = 0;
  for (double overlap : asked_overlaps(options)) {
    law::Response response =
        options.exact ? law.formulas(state, overlap) : law::evaluate(law, state, overlap);
    state = response.state;
    response.in_range = response.in_range && validity.holds(state.gamma_max);
    outside += !response.in_range;
    rows.push_back({overlap, response});
  }
  if (outside > 0)
    core::say(fmt::format("platen: warning: {} of {} points are outside the validity of the law ({})\n",
                          outside, rows.size(), law::find_law(card.law).validity));
  const std::string text = options.json ? json_of(card, rows) : csv_of(rows);
  if (options.output.empty()) fmt::print("{}", text);
  else core::write_file(options.output, text);
}

} // namespace

void add_eval(Command program) {
  auto command = program.add_subcommand("eval", "force, contact radius and stiffness of a law over overlap");
  auto options = std::make_shared<Options>();
  add_law_arguments(command, options->law);
  command.add_option("--with", options->partner,
                     "law card of the second body, where it is of another material");
  command.add_option("--overlap", options->overlap, "FROM:TO:COUNT [m], both ends included, or one overlap");
  command.add_option("--path", options->path, "CSV with the column overlap_m; the state is carried along");
  command.add_option("-o", options->output, "file to write instead of printing");
  command.add_flag("--exact", options->exact,
                   "by the law's formulas instead of the table that contact loops run, 1e-4 from them");
  command.add_flag("--json", options->json, "for a machine to read");
  command.footer("Overlap is the approach of the two centres; with --against plane that of the centre.\n"
                 "Example: platen eval hertz -p radius_m=1e-3 -p E_Pa=1e9 -p nu=0.3 --overlap 0:1e-5:11\n"
                 "         platen eval soft.toml --with hard.toml -p radius_m=1e-3 -p radius2_m=2e-3 "
                 "--overlap 0:1e-4:11");
  command.callback([options] { eval(*options); });
}

} // namespace platen::app
