#include "app/commands.hpp"
#include "app/press_into.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "measure/as_measured.hpp"
#include "press/case_card.hpp"
#include "press/confined.hpp"
#include "press/regimes.hpp"
#include "press/tension.hpp"

#include <fmt/format.h>

#include <memory>

namespace platen::app {
namespace {

struct Options {
  std::string card, folder = "out", model;
  bool json = false, keys = false, estimate_error = false;
  std::string as_measured;
  measure::Instrument instrument{.gap_m = 20e-6, .noise = 0.01};
  int particles = 1, seed = 1;
};

/// The curve as an instrument would have written it.
void write_measured(const Options& o, const press::Case& c, const press::Curve& curve) {
  const auto batch =
      measure::batch(curve, o.particles, 2 * c.radius_m, o.instrument, static_cast<std::uint64_t>(o.seed));
  core::write_file(o.as_measured, measure::raw_text(batch));
}

void press(const Options& options) {
  if (options.keys) {
    fmt::print("{}", press::case_reference());
    return;
  }
  auto c = press::read_case(options.card);
  if (!options.as_measured.empty() && !std::holds_alternative<press::Simple>(c.experiment))
    throw core::InvalidInput(fmt::format("--as-measured is for experiment = \"simple\", not \"{}\"",
                                         press::name_of(c.experiment)));
  if (!options.model.empty()) c.material.model = material::run_as(c.material.model, options.model);
  const core::OutputFolder folder(options.folder);
  const auto [result, summary] =
      press_into(c, folder, plot::Fields::pictures_and_vtu, options.estimate_error);
  print_flags(result);
  if (!options.as_measured.empty()) write_measured(options, c, result.curve);
  if (options.json) {
    fmt::print("{}", summary);
    return;
  }
  const auto& last = *press::loading_end(result.curve);
  fmt::print(
      "{}: {} points, loaded to delta_bar = {:.4g}, F_bar = {:.4g} (F = {:.4g} N), contact radius {:.4g} "
      "R, in {:.1f} s\n"
      "{}\n"
      "{}{}"
      "results in {}\n",
      c.material.name, result.curve.points.size(), last.delta_bar, last.F_bar, last.force_N,
      last.contact_radius_m / c.radius_m, result.statistics.total_s,
      press::tension_words(result.curve, c.material.tensile_strength), error_words(result),
      press::is_confined(c.experiment) ? press::regimes_words(press::regimes(result.curve)) : "",
      folder.path().string());
}

} // namespace

void add_press(Command program) {
  auto command = program.add_subcommand(
      "press", "press one virtual particle: curve.csv, summary.json, pictures, fields");
  auto options = std::make_shared<Options>();
  auto card = command.add_option("CASE.toml", options->card, "the case card");
  command.add_option("-o", options->folder, "folder for the results").type_name("DIR").capture_default_str();
  command
      .add_option("--model", options->model,
                  "run a vmdc or dpc card as vmdc, dpc, dpc-published or von-mises")
      .type_name("NAME");
  command.add_flag("--estimate-error", options->estimate_error,
                   "press on half as many elements too, and say how far force and radius are from the limit");
  auto measured =
      command
          .add_option("--as-measured", options->as_measured,
                      "write here too what an instrument would have, with loops where branches unload")
          .type_name("RAW.csv");
  command.add_option("--particles", options->particles, "how many, each with a size and a gap of its own")
      .type_name("NUMBER")
      .range(1, 1000)
      .capture_default_str();
  command.add_option("--noise", options->instrument.noise, "of the force, over the largest")
      .type_name("SHARE")
      .range(0.0, 0.5)
      .capture_default_str();
  command.add_option("--gap_m", options->instrument.gap_m, "way of the platens before contact")
      .type_name("NUMBER")
      .capture_default_str();
  command
      .add_option("--compliance_m_per_N", options->instrument.compliance_m_per_N,
                  "how much the machine gives way")
      .type_name("NUMBER")
      .capture_default_str();
  command.add_option("--seed", options->seed, "of the noise: the same seed, the same file")
      .type_name("NUMBER")
      .capture_default_str();
  command.add_flag("--json", options->json, "print the summary for a machine to read");
  auto keys = command.add_flag("--keys", options->keys, "every key of a case card, as Markdown");
  keys.excludes(card);
  measured.excludes(keys);
  command.footer("Example: platen press case.toml -o out/press\n"
                 "with case.toml:\n\n"
                 "  platen = 1\n  experiment = \"simple\"\n  material = \"mcc-ph-200\"\n  radius_m = 1e-3\n"
                 "  [output]\n  fields_at = [0.1, 0.5]\n\n"
                 "Small contacts: experiment = \"local\", [path] force_max_N = 100\n"
                 "Confined: experiment = \"die\" or \"hydrostatic\", or \"triaxial\" with [path] delta_bar = "
                 "[...],\ndelta_bar_x = [...], delta_bar_y = [...]");
  command.callback([options] {
    if (options->card.empty() && !options->keys) refuse_missing("CASE.toml");
    press(*options);
  });
}

} // namespace platen::app
