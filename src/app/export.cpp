#include "app/commands.hpp"
#include "app/export_dem_engine.hpp"
#include "app/export_lammps.hpp"
#include "app/export_parameters.hpp"
#include "app/law_arguments.hpp"
#include "core/file.hpp"
#include "dem/law_table.hpp"

#include <fmt/format.h>

#include <memory>

namespace platen::app {
namespace {

struct Options {
  LawArguments law;
  std::string overlap, output;
};

void export_table(const Options& options) {
  fit::LawCard card = card_of(options.law);
  const auto more = parameters_of(options.law);
  const law::Law law = fit::make_law(card, more);
  for (const auto& [key, value] : more) card.parameters[key] = value;
  const std::string text = dem::law_table(card, law, overlaps_of(options.overlap));
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
  add_export_dem_engine(command);
  add_export_parameters(command);
  command.footer("Example: platen export table mcc.toml -p radius_m=1e-3 --overlap 1e-6:5e-4:500 -o mcc.csv");
}

} // namespace platen::app
