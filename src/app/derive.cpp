#include "app/commands.hpp"
#include "app/derive_local.hpp"
#include "app/fit_report.hpp"
#include "app/press_into.hpp"
#include "core/error.hpp"
#include "core/nearest.hpp"
#include "core/say.hpp"
#include "fit/derivation.hpp"
#include "material/card.hpp"
#include "press/tension.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

namespace platen::app {
namespace {

struct Options {
  std::string material, folder = "out", law = "pressed", variant = "published", unload_from, model;
  press::Simple experiment;
  double radius_m = press::Case{}.radius_m;
  std::optional<double> delta_bar_max, force_max_N;
  std::vector<std::string> simple_only; ///< options given that the local press does not have
  bool json = false, estimate_error = false;
};

void derive_simple(const Options& o, const material::Material& material) {
  fit::check_variant(o.variant);
  if (o.force_max_N) throw core::InvalidInput("--force_max_N is for --law wang; give --delta_bar_max");
  press::Simple e = o.experiment;
  if (o.delta_bar_max) e.delta_bar_max = *o.delta_bar_max;
  const press::Case c = fit::simple_derivation(material, o.radius_m, e, unloading_list(o.unload_from));

  const core::OutputFolder folder(o.folder);
  const press::Result result = press_into(c, folder, plot::Fields::pictures, o.estimate_error).result;
  print_flags(result);
  const auto laws = fit::derive_laws(result, o.variant, core::say_line);
  const bool published_first = o.law == "edmans-sinka";
  plot::write_laws(result.curve, laws, published_first, folder);
  if (o.json) {
    fmt::print("{}", fit_json(result.curve, laws.fitted, laws.pressed));
    return;
  }
  const std::string at = folder.path().string();
  fmt::print("{}: pressed to delta_bar = {:.4g} in {:.1f} s; {}\n{}{}", c.material.name, e.delta_bar_max,
             result.statistics.total_s, press::tension_words(result.curve, c.material.tensile_strength),
             fit_words(laws.pressed), fit_words(laws.fitted));
  fmt::print("  law cards      {0}/law.toml ({1}), {0}/{2}\n  curve          {0}/curve.csv, with the law "
             "{0}/curve.svg\n"
             "  plastic zones  {0}/zones.svg\n  input, summary {0}/case.toml, {0}/summary.json\n",
             at, published_first ? "edmans-sinka" : "pressed",
             published_first ? "pressed.toml" : "edmans-sinka.toml");
}

void derive(const Options& o) {
  const std::vector<std::string> laws = {"pressed", "edmans-sinka", "wang"};
  if (std::ranges::find(laws, o.law) == laws.end())
    throw core::InvalidInput(
        fmt::format("--law {}: there is no such law to fit{}", o.law, core::suggestion(o.law, laws)));
  material::Material material = material::read_card(o.material).material;
  if (!o.model.empty()) material.model = material::run_as(material.model, o.model);
  if (o.law != "wang") return derive_simple(o, material);
  if (!o.simple_only.empty())
    throw core::InvalidInput(fmt::format("{} is not for --law wang", fmt::join(o.simple_only, ", ")));
  derive_local({material, o.folder, o.radius_m, o.delta_bar_max, o.force_max_N, o.unload_from, o.json});
}

} // namespace

void add_derive(Command program) {
  auto command = program.add_subcommand("derive", "the main job: press a material, fit the law, draw both");
  auto o = std::make_shared<Options>();
  command.add_option("MATERIAL", o->material, "material card, or a name in the catalogue").required();
  command.add_option("-o", o->folder, "folder for the results").type_name("DIR").capture_default_str();
  command.add_option("--model", o->model, "run a vmdc or dpc card as vmdc, dpc, dpc-published or von-mises")
      .type_name("NAME");
  command
      .add_option("--law", o->law,
                  "the law of law.toml: pressed, the curve itself, or edmans-sinka, its published form (of "
                  "the same press; the "
                  "other is written beside it); wang, of small contacts in stiff grains (local press)")
      .type_name("NAME")
      .capture_default_str();
  auto variant =
      command.add_option("--variant", o->variant, variant_help).type_name("V").capture_default_str();
  command
      .add_option(
          "--unload_from", o->unload_from,
          "delta/R0 from which branches unload: 0.1,0.3; none; default: five up to the end (wang: four)")
      .type_name("LIST");
  command.add_option("--radius_m", o->radius_m, "radius; the law does not depend on it")
      .type_name("NUMBER")
      .capture_default_str();
  command
      .add_option("--delta_bar_max", o->delta_bar_max,
                  "how far to press, delta/R0 in (0, 0.5]; default 0.5, wang: five times first yield")
      .type_name("NUMBER");
  command.add_option("--force_max_N", o->force_max_N, "wang: how far to press").type_name("NUMBER");
  auto elements = command.add_option("--elements", o->experiment.elements, "wanted number of elements")
                      .type_name("NUMBER")
                      .capture_default_str();
  command.add_flag(
      "--estimate-error", o->estimate_error,
      "press on half as many elements too; the law card says how far the press is from the limit");
  command.add_flag("--json", o->json, "for a machine to read");
  command.footer("Example: platen derive mcc-ph-200 -o out/mcc\n"
                 "         platen derive wang-type-1 --law wang --radius_m 0.1 -o out/sand");
  command.callback([o, variant, elements] {
    for (const auto& option : {variant, elements})
      if (option.given()) o->simple_only.push_back(option.name());
    derive(*o);
  });
}

} // namespace platen::app
