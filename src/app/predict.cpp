#include "app/commands.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/number.hpp"
#include "core/say.hpp"
#include "core/version.hpp"
#include "material/card.hpp"
#include "surrogate/predict_law.hpp"
#include "surrogate/rock.hpp"
#include "surrogate/yield_from.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>
#include <optional>

namespace platen::app {
namespace {

struct Options {
  std::string material, output = "law.toml", law, variant = "published", material_card;
  std::optional<double> E_Pa, nu, sigma_y_Pa, hardness_Pa, heckel_Pa, crush_force_N, crush_overlap_m,
      radius_m, strain_index, bonding_index, relative_density;
  bool quick = false, extrapolate = false, json = false;
};

/// As it is, or from what is known instead.
double yield_stress_of(const Options& o) {
  if (o.hardness_Pa) {
    const double sigma_y = surrogate::yield_from_hardness(*o.E_Pa, *o.nu, *o.hardness_Pa);
    core::say_line(fmt::format(
        "note: sigma_y = hardness/2.8 = {:.4g} Pa (Tabor: the indentation is fully plastic, and nothing "
        "hardens)",
        sigma_y));
    return sigma_y;
  }
  if (o.heckel_Pa) {
    const double sigma_y = surrogate::yield_from_heckel(*o.E_Pa, *o.nu, *o.heckel_Pa);
    core::say_line(fmt::format("note: sigma_y = P_y/3 = {:.4g} Pa (Heckel: solid grains, perfectly plastic, "
                               "measured out of the die)",
                               sigma_y));
    return sigma_y;
  }
  if (o.crush_force_N || o.crush_overlap_m || o.radius_m) {
    for (const auto& [name, value] : {std::pair{"--crush_force_N", o.crush_force_N},
                                      {"--crush_overlap_m", o.crush_overlap_m},
                                      {"--radius_m", o.radius_m}})
      if (!value) refuse_missing(name);
    const double sigma_y =
        surrogate::yield_from_crushing(*o.E_Pa, *o.nu, *o.crush_force_N, *o.crush_overlap_m, *o.radius_m);
    core::say_line(fmt::format(
        "note: sigma_y = {:.4g} Pa, for the sphere to carry {:.4g} N there (perfectly plastic, not broken)",
        sigma_y, *o.crush_force_N));
    return sigma_y;
  }
  if (!o.sigma_y_Pa) refuse_missing("--sigma_y_Pa");
  return *o.sigma_y_Pa;
}

material::Material granule_of(const Options& o) {
  if (!o.material.empty() || o.E_Pa || o.nu || o.sigma_y_Pa || o.heckel_Pa || o.crush_force_N ||
      o.crush_overlap_m || o.radius_m)
    throw core::InvalidInput("indices describe a granule: give --strain_index, --bonding_index, "
                             "--hardness_Pa and --relative_density, and no material beside them");
  for (const auto& [name, value] : {std::pair{"--strain_index", o.strain_index},
                                    {"--bonding_index", o.bonding_index},
                                    {"--hardness_Pa", o.hardness_Pa},
                                    {"--relative_density", o.relative_density}})
    if (!value) refuse_missing(name);
  const material::Vmdc granule =
      surrogate::granule_from({*o.strain_index, *o.bonding_index, *o.hardness_Pa, *o.relative_density});
  core::say_line(fmt::format("note: E_bar = {:.4g}, Lambda_bar = {:.4g}, sigma_y_Pa = {:.4g} at relative "
                             "density {}; all else as in the card base-case",
                             granule.E / granule.sigma_y, granule.Lambda / granule.sigma_y, granule.sigma_y,
                             granule.rho_r0));
  return {"granule of these indices", granule};
}

material::Material material_of(const Options& o) {
  if (o.strain_index || o.bonding_index || o.relative_density) return granule_of(o);
  const bool crushing = o.crush_force_N || o.crush_overlap_m || o.radius_m;
  const bool flags = o.E_Pa || o.nu || o.sigma_y_Pa || o.hardness_Pa || o.heckel_Pa || crushing;
  if (flags && !o.material.empty())
    throw core::InvalidInput(
        fmt::format("{}: give a material, or --E_Pa, --nu and --sigma_y_Pa, not both", o.material));
  if (!flags) {
    if (o.material.empty()) refuse_missing("MATERIAL, or --E_Pa, --nu and --sigma_y_Pa,");
    return material::read_card(o.material).material;
  }
  for (const auto& [name, value] : {std::pair{"--E_Pa", o.E_Pa}, {"--nu", o.nu}})
    if (!value) refuse_missing(name);
  if (o.sigma_y_Pa.has_value() + o.hardness_Pa.has_value() + o.heckel_Pa.has_value() + crushing > 1)
    throw core::InvalidInput(
        "--sigma_y_Pa, --hardness_Pa, --heckel_Pa, --crush_force_N with --crush_overlap_m and "
        "--radius_m: each says the yield "
        "stress; give one");
  const double sigma_y = yield_stress_of(o);
  // Read as a card would be, so that what is refused there is refused here.
  const auto card = core::parse_toml(
      fmt::format("platen = 1\nname = \"perfectly plastic metal\"\nmodel = "
                  "\"von-mises\"\n[parameters]\nE_Pa = {}\nnu = {}\nsigma_y_Pa = {}\n",
                  core::number_text(*o.E_Pa), core::number_text(*o.nu), core::number_text(sigma_y)),
      "--E_Pa, --nu, --sigma_y_Pa");
  return material::read_card(card).material;
}

double at(const surrogate::Answer& answer, const std::vector<double>& values, double delta_bar) {
  const auto& knots = answer.surrogate.knots;
  const auto found = std::lower_bound(knots.begin(), knots.end(), delta_bar - 1e-9);
  return values[static_cast<std::size_t>(std::min(found, knots.end() - 1) - knots.begin())];
}

std::string words(const Options& o, const std::string& law, const material::Material& material,
                  const surrogate::Answer& answer, const std::vector<surrogate::Near>& near) {
  const auto& s = answer.surrogate;
  const auto& p = answer.prediction;
  const auto& a = answer.assessment;
  std::string text = fmt::format(
      "{}: law {} from {} materials of pool {}{} (engine {})\n", material.name, law, s.runs.size(), s.pool,
      answer.guided ? fmt::format(" and a press on {} elements", s.guide->elements) : "", s.engine);
  text += fmt::format("  verdict        {}{}{}\n", name_of(a.verdict), a.reasons.empty() ? "" : ": ",
                      fmt::join(a.reasons, "; "));
  const double end = s.knots[a.knots - 1];
  const auto row = [&](const std::vector<double>& values) {
    return std::pair{at(answer, values, 0.1), at(answer, values, end)};
  };
  const auto [F_early, F_end] = row(p.F_bar);
  const auto [band_early, band_end] = row(p.band);
  text += fmt::format("  force          F/(pi R0^2 sigma_ref) = {:.4g} at delta/R0 = 0.1, {:.4g} at {:.4g}\n",
                      F_early, F_end, end);
  text += fmt::format("  90 % band      {:.2g} % at 0.1, {:.2g} % at {:.4g} to either side; curve expected "
                      "to be {:.2g} % off\n",
                      100 * band_early, 100 * band_end, end, 100 * p.expected[a.knots - 1]);
  const char* title = "nearest        ";
  for (const auto& one : near) {
    text += fmt::format("  {}{}\n", title, surrogate::words(s, one));
    title = "               ";
  }
  return text + fmt::format("  law card       {}\n", o.output);
}

std::string json_of(const material::Material& material, const surrogate::Answer& answer,
                    const std::vector<surrogate::Near>& near) {
  const auto& s = answer.surrogate;
  const auto& p = answer.prediction;
  const auto& a = answer.assessment;
  nlohmann::ordered_json runs = nlohmann::ordered_json::array();
  for (const auto& one : near) runs.push_back(s.runs[one.index]);
  return nlohmann::ordered_json{{"platen", core::version},
                                {"material", material.name},
                                {"pool", s.pool},
                                {"engine", s.engine},
                                {"guided", answer.guided},
                                {"verdict", name_of(a.verdict)},
                                {"reasons", a.reasons},
                                {"expected_error", p.expected[a.knots - 1]},
                                {"delta_bar_end", s.knots[a.knots - 1]},
                                {"nearest_runs", runs},
                                {"delta_bar", s.knots},
                                {"F_bar", p.F_bar},
                                {"band_90", p.band},
                                {"a_bar", p.a_bar},
                                {"unload_delta_bar", s.unload_delta_bar},
                                {"alpha", p.alpha},
                                {"beta", p.beta}}
             .dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
         "\n";
}

std::string rock_words(const Options& o, const material::Material& material,
                       const surrogate::PredictedRock& p) {
  std::string text =
      fmt::format("{}: law wang from {} grains of pool {} (engine {})\n  verdict        {}{}{}\n",
                  material.name, p.rock.grains.size(), p.rock.pool, p.rock.engine, name_of(p.verdict),
                  p.reasons.empty() ? "" : ": ", fmt::join(p.reasons, "; "));
  text += fmt::format("  first yield    at {:.3g} N of a grain of R = {:.3g} m, pressed to {:.3g} N{}\n",
                      p.yield * p.rock.force_N, p.rock.radius_m, p.rock.force_N,
                      p.yield > 1 ? ": it stays elastic, or nearly" : "");
  for (std::size_t k = 0; k < 4; ++k)
    text += fmt::format("  {:<14} {:.5g}; left out, {:.2g} % off (median), one in twenty {:.2g} %\n",
                        surrogate::coefficient_names[k], p.of[k], 100 * p.rock.left_out.of[k].median,
                        100 * p.rock.left_out.of[k].p95);
  text += fmt::format("  force          {:.2g} % off (median, relative L2), one in twenty {:.2g} %\n",
                      100 * p.rock.left_out.force.median, 100 * p.rock.left_out.force.p95);
  const char* title = "nearest        ";
  for (const auto& one : p.near) {
    text += fmt::format("  {}{}\n", title, one);
    title = "               ";
  }
  return text + fmt::format("  law card       {}\n", o.output);
}

std::string rock_json(const material::Material& material, const surrogate::PredictedRock& p) {
  nlohmann::ordered_json json = {{"platen", core::version},       {"material", material.name},
                                 {"pool", p.rock.pool},           {"engine", p.rock.engine},
                                 {"verdict", name_of(p.verdict)}, {"reasons", p.reasons},
                                 {"F_y_over_F", p.yield}};
  for (std::size_t k = 0; k < 4; ++k) {
    json[surrogate::coefficient_names[k]] = p.of[k];
    json["left_out"][surrogate::coefficient_names[k]] = {
        p.rock.left_out.of[k].median, p.rock.left_out.of[k].p95, p.rock.left_out.of[k].worst};
  }
  json["nearest_runs"] = p.near;
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void predict(const Options& o) {
  const auto material = material_of(o);
  if (!o.material_card.empty()) {
    if (!o.material.empty())
      throw core::InvalidInput(fmt::format("--material-card: {} is the card of this material", o.material));
    core::write_file(o.material_card, material::card_text(material));
  }
  const auto law = surrogate::law_to_predict(material, o.law);
  if (law == "wang") {
    const auto rock = surrogate::predict_rock(material, o.material);
    core::write_file(o.output, text_of(rock.card));
    fmt::print(report_stream(o.output), "{}",
               o.json ? rock_json(material, rock) : rock_words(o, material, rock));
    return;
  }
  surrogate::PredictOptions options{law, o.variant, o.quick, o.extrapolate};
  for (const auto& card : {o.material, o.material_card})
    if (!card.empty()) options.card = card;
  const auto [card, answer, near] = surrogate::predict_law(material, options, core::say_line);
  core::write_file(o.output, text_of(card));
  fmt::print(report_stream(o.output), "{}",
             o.json ? json_of(material, answer, near) : words(o, law, material, answer, near));
}

} // namespace

void add_predict(Command program) {
  auto command =
      program.add_subcommand("predict", "a law at once, from materials that were pressed, with its error");
  auto o = std::make_shared<Options>();
  command.add_option("MATERIAL", o->material, "material card, or a name in the catalogue");
  command.add_option("--E_Pa", o->E_Pa, "instead of a material, a perfectly plastic metal: Young's modulus")
      .type_name("NUMBER");
  command.add_option("--nu", o->nu, "its Poisson's ratio").type_name("NUMBER");
  command.add_option("--sigma_y_Pa", o->sigma_y_Pa, "its yield stress").type_name("NUMBER");
  command
      .add_option("--hardness_Pa", o->hardness_Pa,
                  "instead of the yield stress: hardness, H = 2.8 sigma_y (Tabor)")
      .type_name("NUMBER");
  command
      .add_option("--heckel_Pa", o->heckel_Pa,
                  "instead: yield pressure of tablets, out of the die, P_y = 3 sigma_y (Heckel)")
      .type_name("NUMBER");
  command
      .add_option(
          "--crush_force_N", o->crush_force_N,
          "instead: the force that a sphere carries between two plates, with --crush_overlap_m, --radius_m")
      .type_name("NUMBER");
  command
      .add_option("--crush_overlap_m", o->crush_overlap_m,
                  "its overlap with one plate: half of what the plates came together")
      .type_name("NUMBER");
  command.add_option("--radius_m", o->radius_m, "of that sphere").type_name("NUMBER");
  command
      .add_option("--strain_index", o->strain_index,
                  "instead of a material, a granule: Hiestand's strain index H/E', with --bonding_index, "
                  "--hardness_Pa, --relative_density")
      .type_name("NUMBER");
  command.add_option("--bonding_index", o->bonding_index, "its bonding index, tensile strength over hardness")
      .type_name("NUMBER");
  command.add_option("--relative_density", o->relative_density, "of the compacts that were tested")
      .type_name("NUMBER");
  command.add_option("-o", o->output, "the law card").type_name("LAW.toml").capture_default_str();
  command
      .add_option("--material-card", o->material_card,
                  "write the material here that the numbers describe, for `platen derive`")
      .type_name("MATERIAL.toml");
  command
      .add_option("--law", o->law,
                  "pressed: the curve itself, the default; edmans-sinka: fitted to the "
                  "curve; wang: of rock (drucker-prager), the default there")
      .type_name("NAME");
  command.add_option("--variant", o->variant, "form of edmans-sinka").type_name("V").capture_default_str();
  command.add_flag("--quick", o->quick,
                   "powders: without the press on few elements that comes first, a second or two; less sure");
  command.add_flag("--extrapolate", o->extrapolate, "outside of what was pressed: guess, with a warning");
  command.add_flag("--json", o->json, "for a machine to read");
  command.footer("Example: platen predict mcc-ph-200 -o law.toml\n"
                 "         platen predict --E_Pa 2e9 --nu 0.3 --sigma_y_Pa 2e7 -o law.toml\n"
                 "         platen predict wang-type-1 -o law.toml");
  command.callback([o] { predict(*o); });
}

} // namespace platen::app
