#include "app/commands.hpp"
#include "app/law_arguments.hpp"
#include "app/measured_arguments.hpp"
#include "calibrate/ask.hpp"
#include "calibrate/calibration.hpp"
#include "calibrate/confined.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/number.hpp"
#include "core/parallel.hpp"
#include "core/say.hpp"
#include "plot/gnuplot.hpp"
#include "plot/measured/confined_prediction.hpp"
#include "plot/measured/measured_picture.hpp"
#include "plot/measured/profile_picture.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>

namespace platen::app {
namespace {

struct Options {
  std::vector<std::string> curves, parameters;
  std::string law, material, free, variant, card, law_card, picture, ask, tell, confined;
  MeasuredArguments measured;
  std::optional<double> E_Pa, nu;
  std::optional<Option> profiles_option;
  std::string profiles; ///< their picture
  std::string store;    ///< of the presses
  int workers = core::processors();
  bool press = false, json = false;

  bool all_profiles() const { return profiles_option && profiles_option->given(); }

  /// Whether a material is looked for.
  bool of_material() const { return !material.empty(); }
};

/// --model takes a law or a model of material; --material a model or a card.
void settle_what(Options& o) {
  if (!o.law.empty() && !o.material.empty())
    throw core::InvalidInput(
        fmt::format("--law {} and --material {}: give one of the two", o.law, o.material));
  if (calibrate::is_material_model(o.law)) std::swap(o.law, o.material);
  if (o.law.empty() && o.material.empty()) refuse_missing("--law, or --material,");
  for (const auto& [option, value] : {std::pair{"--free", o.free}, {"--law-card", o.law_card}})
    if (!value.empty() && !o.of_material())
      throw core::InvalidInput(fmt::format("{} is for --material", option));
  if (o.ask.empty() != o.tell.empty()) refuse_missing(o.ask.empty() ? "--ask" : "--tell");
  if (o.press && !o.of_material()) throw core::InvalidInput("--press is for --material");
  if (!o.store.empty() && !o.press) throw core::InvalidInput("--store is for --press");
  if (o.of_material() && !o.variant.empty()) throw core::InvalidInput("--variant is for --law");
}

std::vector<std::string> list_of(const std::string& text) {
  std::vector<std::string> list;
  for (std::size_t from = 0; from < text.size();) {
    const auto comma = std::min(text.find(',', from), text.size());
    list.push_back(text.substr(from, comma - from));
    from = comma + 1;
  }
  return list;
}

calibrate::Settings settings_of(const Options& o) {
  calibrate::Settings settings;
  settings.law = o.law;
  settings.variant = o.variant;
  for (const auto& p : o.parameters) {
    const auto [key, value] = parameter_from(p);
    settings.given[key] = value;
  }
  if (o.E_Pa) settings.given["E_Pa"] = core::number_text(*o.E_Pa);
  if (o.nu) settings.given["nu"] = core::number_text(*o.nu);
  settings.machine = machine_of(o.measured);
  settings.all_profiles = o.all_profiles();
  if (o.of_material())
    settings.material =
        std::make_shared<calibrate::FreeMaterial>(o.material, settings.given, list_of(o.free));
  else (void)calibrate::free_law(o.law);
  if (!o.ask.empty()) settings.asked = calibrate::read_asked(o.ask, calibrate::free_parameters(settings));
  return settings;
}

/// An end that is open is null.
nlohmann::ordered_json json_of(const calibrate::Profile& p) {
  nlohmann::ordered_json points = nlohmann::ordered_json::array();
  for (const auto& point : p.points) points.push_back({point.value, point.deviance});
  nlohmann::ordered_json low, high;
  if (!p.open_low) low = p.low;
  if (!p.open_high) high = p.high;
  return {{"interval_95", {low, high}}, {"value_deviance", points}};
}

std::string json_of(const calibrate::Calibration& c, const std::vector<std::string>& flags) {
  nlohmann::ordered_json parameters, errors, noise, profiles = nlohmann::ordered_json::object(),
                                                    particles = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < c.free.size(); ++k) {
    parameters[c.free[k].key] = c.values[k];
    errors[c.free[k].key] = c.errors[k];
    noise[c.free[k].key] = c.noise_errors[k];
    if (c.profiles[k]) profiles[c.free[k].key] = json_of(*c.profiles[k]);
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
  const nlohmann::ordered_json json = {
      {c.material ? "material" : "law",
       c.material ? std::string(material::model_name(c.material->model)) : c.card.law},
      {"parameters", parameters},
      {"standard_errors", errors},
      {"standard_errors_of_noise", noise},
      {"profiles", profiles},
      {"correlations", c.correlations},
      {"R2", c.R2},
      {"delta_bar_max", c.delta_bar_max},
      {"particles", particles},
      {"broken", c.broken},
      {"remarks", c.said},
      {"doubts", flags}};
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void write_confined(const calibrate::Calibration& c, const std::string& file) {
  const auto curves = calibrate::confined(c);
  core::say_line(
      fmt::format("note: the bands of {} are those of the parameters, not of how far law {} is off under "
                  "confinement (docs/laws/{}.md)",
                  file, c.card.law, c.card.law));
  if (file.ends_with(".csv")) core::write_file(file, calibrate::confined_csv(curves));
  else plot::confined_prediction(c, curves, file);
}

calibrate::Calibration by_presses(const std::vector<measure::Measurement>& measurements,
                                  const calibrate::Settings& settings, const Options& o) {
  study::Store store(o.store.empty() ? "out/calibration" : o.store, "calibration");
  store.open_for_writing(study::OldRuns::recompute);
  return calibrate::calibrate_material_by_presses(measurements, settings, {store, o.workers, core::say_line});
}

void run_calibrate(Options o) {
  settle_what(o);
  const auto settings = settings_of(o);
  for (const std::string& file : {o.picture, o.profiles, o.confined.ends_with(".csv") ? "" : o.confined})
    if (!file.empty()) (void)plot::format_of(file);
  const auto measurements = measurements_of(o.curves, o.measured);
  auto c = o.press           ? by_presses(measurements, settings, o)
           : o.of_material() ? calibrate::calibrate_material(measurements, settings)
                             : calibrate::calibrate(measurements, settings);
  if (!o.picture.empty()) plot::measured_picture(measurements, c, o.picture); // also of what is refused then
  if (!o.profiles.empty()) plot::profile_picture(c, o.profiles);
  std::string words = words_of(c);
  std::vector<std::string> flags;
  try {
    flags = fit::pass(c.doubts, o.measured.despite_doubts());
  } catch (const core::InvalidInput&) {
    if (!o.json) fmt::print("{}", words); // what was found helps to see why
    throw;
  }
  if (!flags.empty()) c.card.provenance.emplace_back("doubts", fmt::format("{}", fmt::join(flags, "; ")));
  if (!o.confined.empty()) write_confined(c, o.confined);
  if (!o.tell.empty())
    core::write_file(o.tell, o.tell.ends_with(".json") ? calibrate::told_json(c) : calibrate::told_csv(c));
  const auto& law_card = o.of_material() ? o.law_card : o.card;
  if (!law_card.empty()) core::write_file(law_card, text_of(c.card));
  if (o.of_material() && !o.card.empty()) core::write_file(o.card, calibrate::material_card(c, flags));
  for (const auto& flag : flags) words += fmt::format("doubted: {}\n", flag);
  fmt::print(report_stream(o.card), "{}", o.json ? json_of(c, flags) : words);
}

} // namespace

void add_calibrate(Command program) {
  auto command = program.add_subcommand("calibrate", "a contact law, or a material, from measured particles");
  auto o = std::make_shared<Options>();
  command
      .add_option("CURVES", o->curves,
                  "files of instruments, or of platen import; all particles of all files")
      .required();
  command
      .add_option("--law,--model", o->law,
                  fmt::format("law to calibrate: {}", fmt::join(calibrate::calibrated_laws(), ", ")))
      .type_name("NAME");
  command
      .add_option("--material", o->material,
                  "look for a material instead: elastic, von-mises, vmdc, or a card of a similar one")
      .type_name("MODEL|CARD");
  command
      .add_option("--free", o->free,
                  "its parameters that are looked for, with commas; default: strength and E")
      .type_name("KEYS");
  command.add_option("--variant", o->variant, "variant of the law").type_name("V");
  command.add_option("--nu", o->nu, "Poisson's ratio, which no force curve shows").type_name("NUMBER");
  command.add_option("--E_Pa", o->E_Pa, "Young's modulus, where it is known").type_name("NUMBER");
  command.add_option("-p", o->parameters, "another parameter that is known, key=value");
  command.add_option("-o", o->card, "write the card of the law, or of the material, here")
      .type_name("CARD.toml");
  command.add_option("--law-card", o->law_card, "write the law that the material would have here")
      .type_name("LAW.toml");
  command.add_flag("--press", o->press,
                   "curves of the material from a few presses, minutes, instead of from those of the "
                   "catalogue");
  command
      .add_option("--store", o->store,
                  "the presses are kept here, and those that are there already are not done again; default "
                  "out/calibration")
      .type_name("DIR");
  command.add_option("--workers", o->workers, "processes that press").range(1, 1024);
  o->profiles_option = command
                           .add_option("--profiles", o->profiles,
                                       "profile likelihood of every parameter, not only of what is weakly "
                                       "determined; drawn here: .svg or .png")
                           .type_name("FILE");
  o->profiles_option->value_optional();
  command
      .add_option("--picture", o->picture, "draw what was measured, cut, corrected and fitted: .svg or .png")
      .type_name("FILE");
  command
      .add_option(
          "--confined", o->confined,
          "laws agarwal and shahin: what the particle would do in a die and from all sides, with bands: "
          ".svg, .png or .csv")
      .type_name("FILE");
  command
      .add_option("--ask", o->ask, "for a driver of its own: sets of parameters, a row each under their keys")
      .type_name("SETS.csv");
  command.add_option("--tell", o->tell, "what the particles say of each; .json: with all forces")
      .type_name("FILE");
  add_measured_arguments(command, o->measured, true);
  command.add_flag("--json", o->json, "for a machine to read");
  command.footer(
      "Example: platen calibrate granules.txt --law shahin --nu 0.3 -o law.toml\n"
      "         platen calibrate bead.csv --law hertz --nu 0.22 --radius_m 1e-3 --empty-machine frame.csv\n"
      "         platen calibrate beads.csv --material von-mises --nu 0.3 -o metal.toml --law-card law.toml");
  command.callback([o] { run_calibrate(*o); });
}

} // namespace platen::app
