#include "app/commands.hpp"
#include "app/measured_arguments.hpp"
#include "calibrate/calibration.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/number.hpp"
#include "plot/gnuplot.hpp"
#include "plot/measured_picture.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace platen::app {
namespace {

struct Options {
  std::vector<std::string> curves, parameters;
  std::string law, variant, card, picture;
  MeasuredArguments measured;
  std::optional<double> E_Pa, nu;
  bool json = false;
};

calibrate::Settings settings_of(const Options& o) {
  calibrate::Settings settings;
  settings.law = o.law;
  settings.variant = o.variant;
  for (const auto& p : o.parameters) {
    const auto equals = p.find('=');
    if (equals == std::string::npos || equals == 0)
      throw core::InvalidInput(fmt::format("-p {} is not of the form key=value", p));
    settings.given[p.substr(0, equals)] = p.substr(equals + 1);
  }
  if (o.E_Pa) settings.given["E_Pa"] = core::number_text(*o.E_Pa);
  if (o.nu) settings.given["nu"] = core::number_text(*o.nu);
  settings.machine = machine_of(o.measured);
  return settings;
}

std::string json_of(const calibrate::Calibration& c, const std::vector<std::string>& flags) {
  nlohmann::ordered_json parameters, errors, particles = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < c.free.size(); ++k) {
    parameters[c.free[k].key] = c.values[k];
    errors[c.free[k].key] = c.errors[k];
  }
  for (const auto& p : c.particles)
    particles.push_back({{"name", p.name},
                         {"file", p.file},
                         {"diameter_m", p.diameter_m},
                         {"rows", p.rows},
                         {"contact_travel_m", p.contact_m},
                         {"contact_standard_error_m", p.contact_error_m},
                         {"R2", p.R2},
                         {"values", p.values}});
  const nlohmann::ordered_json json = {{"law", c.card.law},
                                       {"parameters", parameters},
                                       {"standard_errors", errors},
                                       {"correlations", c.correlations},
                                       {"R2", c.R2},
                                       {"delta_bar_max", c.delta_bar_max},
                                       {"particles", particles},
                                       {"broken", c.broken},
                                       {"remarks", c.said},
                                       {"doubts", flags}};
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void calibrate_law(const Options& o) {
  const auto settings = settings_of(o);
  (void)calibrate::free_law(o.law);
  if (!o.picture.empty()) (void)plot::format_of(o.picture);
  const auto measurements = measurements_of(o.curves, o.measured);
  auto c = calibrate::calibrate(measurements, settings);
  if (!o.picture.empty()) plot::measured_picture(measurements, c, o.picture); // also of what is refused then
  std::string words = words_of(c);
  std::vector<std::string> flags;
  try {
    flags = fit::pass(c.doubts, o.measured.despite_doubts());
  } catch (const core::InvalidInput&) {
    if (!o.json) fmt::print("{}", words); // what was found helps to see why
    throw;
  }
  if (!flags.empty()) c.card.provenance.emplace_back("doubts", fmt::format("{}", fmt::join(flags, "; ")));
  if (!o.card.empty()) core::write_file(o.card, text_of(c.card));
  for (const auto& flag : flags) words += fmt::format("doubted: {}\n", flag);
  fmt::print(report_stream(o.card), "{}", o.json ? json_of(c, flags) : words);
}

} // namespace

void add_calibrate(Command program) {
  auto command =
      program.add_subcommand("calibrate", "a contact law from measured particles, contact point included");
  auto o = std::make_shared<Options>();
  command
      .add_option("CURVES", o->curves,
                  "files of instruments, or of platen import; all particles of all files")
      .required();
  command
      .add_option("--law,--model", o->law,
                  fmt::format("law to calibrate: {}", fmt::join(calibrate::calibrated_laws(), ", ")))
      .required()
      .type_name("NAME");
  command.add_option("--variant", o->variant, "variant of the law").type_name("V");
  command.add_option("--nu", o->nu, "Poisson's ratio, which no force curve shows").type_name("NUMBER");
  command.add_option("--E_Pa", o->E_Pa, "Young's modulus, where it is known").type_name("NUMBER");
  command.add_option("-p", o->parameters, "another parameter that is known, key=value");
  command.add_option("-o", o->card, "write the law card here").type_name("LAW.toml");
  command
      .add_option("--picture", o->picture, "draw what was measured, cut, corrected and fitted: .svg or .png")
      .type_name("FILE");
  add_measured_arguments(command, o->measured, true);
  command.add_flag("--json", o->json, "for a machine to read");
  command.footer(
      "Example: platen calibrate granules.txt --law shahin --nu 0.3 -o law.toml\n"
      "         platen calibrate bead.csv --law hertz --nu 0.22 --radius_m 1e-3 --empty-machine frame.csv");
  command.callback([o] { calibrate_law(*o); });
}

} // namespace platen::app
