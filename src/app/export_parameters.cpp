#include "app/export_parameters.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "dem/two_parameters.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <string>

namespace platen::app {

void add_export_parameters(Command command) {
  struct Options {
    std::string law, output;
    double radius_m = 0, delta_bar = 0;
    bool json = false;
  };
  auto parameters = command.add_subcommand(
      "parameters",
      "the nearest Hertz contact and hysteretic springs, and how far they are off, for codes of two numbers");
  auto o = std::make_shared<Options>();
  parameters.add_option("LAW", o->law, "law card").required();
  parameters.add_option("--radius", o->radius_m, "of the spheres [m]").required().type_name("NUMBER");
  parameters
      .add_option("--delta-bar", o->delta_bar,
                  "how far they are pressed, delta/R (default: as far as the card holds)")
      .type_name("NUMBER");
  parameters.add_option("-o", o->output, "file to write instead of printing");
  parameters.add_flag("--json", o->json, "for a machine to read");
  parameters.footer("Example: platen export parameters mcc.toml --radius 1e-3 --delta-bar 0.1");
  parameters.callback([o] {
    if (!(o->radius_m > 0 && o->radius_m < 1e30))
      throw core::InvalidInput("--radius must be a positive number of metres");
    const auto card = fit::find_law_card(o->law);
    const auto p = dem::two_parameters(card, o->radius_m, o->delta_bar);
    nlohmann::ordered_json json = {
        {"radius_m", p.radius_m},
        {"delta_bar", p.delta_bar},
        {"hertz", {{"E_Pa", p.E_Pa}, {"nu", p.nu}, {"force_relative_l2", p.hertz_error}}},
        {"springs",
         {{"k_1_N_per_m", p.k_1_N_per_m},
          {"k_2_N_per_m", p.k_2_N_per_m},
          {"force_relative_l2", p.springs_error}}},
        {"restitution", p.restitution},
        {"restitutions", p.restitutions}};
    const std::string text = o->json ? json.dump(2) + "\n" : words_of(p, card);
    if (o->output.empty()) fmt::print("{}", text);
    else core::write_file(o->output, text);
  });
}

} // namespace platen::app
