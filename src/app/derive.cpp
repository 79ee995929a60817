#include "app/commands.hpp"
#include "app/fit_report.hpp"
#include "app/press_into.hpp"
#include "core/file.hpp"
#include "material/card.hpp"
#include "press/case_card.hpp"
#include "press/curve_csv.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace platen::app {
namespace {

struct Options {
  std::string material, folder = "out", variant = "published", model;
  press::Case press_case;
  bool json = false;
};

/// Where the zone map looks: early, in the middle, at the end.
std::vector<double> moments(double delta_bar_max) {
  return {0.2 * delta_bar_max, 0.6 * delta_bar_max, delta_bar_max};
}

void derive(const Options& o) {
  press::Case c = o.press_case;
  c.material = material::read_card(o.material).material;
  if (!o.model.empty()) c.material.model = material::run_as(c.material.model, o.model);
  press::validate(c);
  c.fields_at = moments(c.delta_bar_max);

  const OutputFolder folder(o.folder);
  const auto result = press_into(c, folder);
  const auto fitted = fit::fit_edmans_sinka(result.curve, o.variant);
  draw_fit(result.curve, fitted, folder / "curve.svg");
  core::write_file(folder / "law.toml", law_card(result.curve, fitted, press::curve_csv(result.curve)));
  print_flags(result);
  if (o.json) {
    fmt::print("{}", fit_json(result.curve, fitted));
    return;
  }
  const std::string at = folder.path().string();
  fmt::print("{}: pressed to delta_bar = {:.4g} in {:.1f} s\n{}", c.material.name, c.delta_bar_max,
             result.statistics.total_s, fit_words(fitted));
  fmt::print("  law card       {0}/law.toml\n  curve          {0}/curve.csv, with the law {0}/curve.svg\n"
             "  plastic zones  {0}/zones.svg\n  input, summary {0}/case.toml, {0}/summary.json\n",
             at);
}

} // namespace

void add_derive(CLI::App& program) {
  auto* command = program.add_subcommand("derive", "the main job: press a material, fit the law, draw both");
  auto o = std::make_shared<Options>();
  command->add_option("MATERIAL", o->material, "material card, or a name in the catalogue")->required();
  command->add_option("-o", o->folder, "folder for the results")->type_name("DIR")->capture_default_str();
  command->add_option("--variant", o->variant, "form of the law")->type_name("V")->capture_default_str();
  command->add_option("--model", o->model, "run a vmdc or dpc card as vmdc, dpc, dpc-published or von-mises")
      ->type_name("NAME");
  command->add_option("--radius_m", o->press_case.radius_m, "radius; the law does not depend on it")
      ->type_name("NUMBER")
      ->capture_default_str();
  command
      ->add_option("--delta_bar_max", o->press_case.delta_bar_max, "how far to press, delta/R0 in (0, 0.5]")
      ->type_name("NUMBER")
      ->capture_default_str();
  command->add_option("--elements", o->press_case.elements, "wanted number of elements")
      ->type_name("NUMBER")
      ->capture_default_str();
  command->add_flag("--json", o->json, "for a machine to read");
  command->footer("Example: platen derive mcc-ph-200 -o out/mcc");
  command->callback([o] { derive(*o); });
}

} // namespace platen::app
