#include "app/commands.hpp"
#include "app/derive_local.hpp"
#include "app/fit_report.hpp"
#include "app/press_into.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/nearest.hpp"
#include "core/number.hpp"
#include "fit/edmans_sinka_card.hpp"
#include "material/card.hpp"
#include "press/case_card.hpp"
#include "press/curve_csv.hpp"
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

/// Where the zone map looks: early, in the middle, at the end.
std::vector<double> moments(double delta_bar_max) {
  return {0.2 * delta_bar_max, 0.6 * delta_bar_max, delta_bar_max};
}

/// Five branches show how alpha and beta change with the overlap (ES Fig. 15).
std::vector<double> fifths(double delta_bar_max) {
  std::vector<double> list;
  for (int i = 1; i < 5; ++i) // in digits that a person would write
    list.push_back(core::number_from(fmt::format("{:.6g}", delta_bar_max * i / 5)).value());
  list.push_back(delta_bar_max);
  return list;
}

/// "0.1,0.3"; "none" for a law that unloads generically; empty: fifths.
std::vector<double> unloading(const std::string& text, double delta_bar_max) {
  if (text.empty()) return fifths(delta_bar_max);
  if (text == "none") return {};
  const std::vector<double> list = unloading_list(text);
  constexpr std::size_t most = law::EdmansSinkaMaterial::most_unloadings;
  if (list.size() > most)
    throw core::InvalidInput(fmt::format(
        "--unload_from {}: a law card holds {} branches at most, these are {}", text, most, list.size()));
  return list;
}

void derive_simple(const Options& o, const material::Material& material) {
  check_variant(o.variant);
  if (o.force_max_N) throw core::InvalidInput("--force_max_N is for --law wang; give --delta_bar_max");
  press::Simple e = o.experiment;
  if (o.delta_bar_max) e.delta_bar_max = *o.delta_bar_max;
  e.unload_from = unloading(o.unload_from, e.delta_bar_max);
  e.fields_at = moments(e.delta_bar_max);
  const press::Case c{material, o.radius_m, e};
  press::validate(c);

  const OutputFolder folder(o.folder);
  const press::Result result = press_into(c, folder, Fields::pictures, o.estimate_error).result;
  print_flags(result);
  const FittedLaw law = fit_law(result.curve, o.variant);
  const fit::PressedFit pressed = fit::fit_pressed(result.curve, law.unloading);
  const std::string text = press::curve_csv(result.curve);
  const bool published_first = o.law == "edmans-sinka";
  const auto write = [&](fit::LawCard card, const std::string& name) {
    if (result.error) {
      card.errors.emplace_back("press_force", result.error->force);
      card.errors.emplace_back("press_radius", result.error->radius);
    }
    core::write_file(folder / name, text_of(card));
  };
  write(fit::law_card(result.curve, pressed, text), published_first ? "pressed.toml" : "law.toml");
  write(fit::law_card(result.curve, law.loading, law.unloading, text),
        published_first ? "law.toml" : "edmans-sinka.toml");
  draw_fit(result.curve, law, folder / "curve.svg");
  if (o.json) {
    fmt::print("{}", fit_json(result.curve, law, pressed));
    return;
  }
  const std::string at = folder.path().string();
  fmt::print("{}: pressed to delta_bar = {:.4g} in {:.1f} s; {}\n{}{}", c.material.name, e.delta_bar_max,
             result.statistics.total_s, press::tension_words(result.curve, c.material.tensile_strength),
             fit_words(pressed), fit_words(law));
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
