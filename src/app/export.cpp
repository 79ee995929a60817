#include "app/commands.hpp"
#include "app/export_lammps.hpp"
#include "app/law_arguments.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/number.hpp"

#include <fmt/format.h>

#include <iterator>
#include <memory>

namespace platen::app {
namespace {

struct Options {
  LawArguments law;
  std::string overlap, output;
};

/// The loading curve, and for every point of it the unloading curve that starts there:
/// F = F_max (1 - rate (overlap_max - overlap))^alpha.
std::string table_of(const fit::LawCard& card, const law::Law& law, const std::vector<double>& overlaps) {
  std::string text =
      fmt::format("# law = {}\n# variant = {}\n", card.law, card.variant.empty() ? "default" : card.variant);
  for (const auto& [key, value] : card.parameters) text += fmt::format("# {} = {}\n", key, value);
  text += "# unloading: F = force_N (1 - unloading_rate_per_m (overlap_max - overlap))^unloading_exponent\n"
          "overlap_m,force_N,stiffness_N_per_m,contact_radius_m,unloading_rate_per_m,unloading_exponent,in_"
          "range\n";
  if (overlaps.front() > overlaps.back())
    throw core::InvalidInput("a table rises: --overlap FROM:TO:COUNT needs FROM < TO");
  for (double overlap : overlaps) {
    if (!(overlap > 0)) throw core::InvalidInput("a table needs overlaps above 0; at 0 the force is 0");
    const auto r = law::evaluate(law, {}, overlap);
    const auto end = law::unloading_at(law, overlap);
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{}\n", core::number_text(overlap),
                   core::number_text(r.force), core::number_text(r.stiffness),
                   core::number_text(r.contact_radius), core::number_text(end.rate),
                   core::number_text(end.alpha), r.in_range ? "true" : "false");
  }
  return text;
}

void export_table(const Options& options) {
  fit::LawCard card = card_of(options.law);
  const auto more = parameters_of(options.law);
  const law::Law law = fit::make_law(card, more);
  for (const auto& [key, value] : more) card.parameters[key] = value;
  const std::string text = table_of(card, law, overlaps_of(options.overlap));
  if (options.output.empty()) fmt::print("{}", text);
  else core::write_file(options.output, text);
}

} // namespace

void add_export(Command program) {
  auto command = program.add_subcommand("export", "a law for a DEM code");
  command.require_subcommand();
  auto table =
      command.add_subcommand("table", "force over overlap, and unloading, as numbers for any DEM code");
  auto options = std::make_shared<Options>();
  add_law_arguments(table, options->law);
  table.add_option("--overlap", options->overlap, "FROM:TO:COUNT [m], above 0").required();
  table.add_option("-o", options->output, "file to write instead of printing");
  table.footer("Example: platen export table mcc.toml -p radius_m=1e-3 --overlap 1e-6:5e-4:500 -o mcc.csv");
  table.callback([options] { export_table(*options); });
  add_export_lammps(command);
  command.footer("Example: platen export table mcc.toml -p radius_m=1e-3 --overlap 1e-6:5e-4:500 -o mcc.csv");
}

} // namespace platen::app
