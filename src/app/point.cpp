#include "app/commands.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/number.hpp"
#include "core/output_folder.hpp"
#include "material/card.hpp"
#include "material/walk.hpp"
#include "plot/walk_picture.hpp"
#include "plot/zone_map.hpp"

#include <fmt/format.h>

#include <limits>
#include <memory>

namespace platen::app {
namespace {

using material::Walk, material::Way;

struct Options {
  std::string card, folder, model;
  Way way;
};

std::string csv_of(const material::Model& model, const Walk& w) {
  std::string text = "step,eps_1,eps_2,eps_3,sigma_1_Pa,sigma_2_Pa,sigma_3_Pa,p_Pa,q_Pa,phi,rho_r,zone\n";
  for (std::size_t i = 0; i < w.points.size(); ++i) {
    const auto& [total, elastic, phi, last] = w.points[i];
    text += std::to_string(i);
    for (const double number : {total[0], total[1], total[2], last.sigma[0], last.sigma[1], last.sigma[2],
                                last.p, last.q, phi, material::relative_density(model, phi)})
      text += "," + core::number_text(number);
    text += "," + plot::zone_name(last.zone) + "\n";
  }
  return text;
}

void point(Options& o) {
  material::Material m = material::read_card(o.card).material;
  if (!o.model.empty()) m.model = material::run_as(m.model, o.model);
  if (!is_named(o.way) && core::is_there(o.way.name)) o.way.rows = material::read_strains(o.way.name);
  const Walk w = material::walk(m.model, o.way);
  const std::string csv = csv_of(m.model, w);
  if (o.folder.empty()) fmt::print("{}", csv);
  else {
    const core::OutputFolder folder(o.folder);
    folder.forget({"point.csv", "surface.svg"});
    core::write_file(folder / "point.csv", csv);
    plot::walk_picture(m, o.way, w, folder / "surface.svg");
    const auto& last = w.points.back();
    fmt::print("{}: {} steps, p = {:.5g} Pa, q = {:.5g} Pa, {}\nresults in {}\n", m.name, w.points.size() - 1,
               last.last.p, last.last.q, plot::zone_name(last.last.zone), folder.path().string());
  }
  if (!w.refusal.empty())
    throw core::ConvergenceError(w.refusal, static_cast<int>(w.points.size()), 0,
                                 std::numeric_limits<double>::quiet_NaN());
}

} // namespace

void add_point(Command program) {
  auto command = program.add_subcommand("point", "lead one material point along a path: stress, state, zone");
  auto o = std::make_shared<Options>();
  command.add_option("CARD", o->card, "material card, or a name in the catalogue").required();
  command
      .add_option("--path", o->way.name,
                  "isotropic, uniaxial-strain, triaxial, shear, or a CSV with eps_1,eps_2,eps_3")
      .required()
      .type_name("PATH");
  command
      .add_option("--strain", o->way.strain,
                  "logarithmic strain at the end, extension positive: of the volume (isotropic), of axis 1")
      .type_name("NUMBER")
      .capture_default_str();
  command.add_option("--steps", o->way.steps, "increments").type_name("NUMBER").capture_default_str();
  command.add_option("--lateral_Pa", o->way.lateral_Pa, "triaxial: stress on axes 2 and 3, tension positive")
      .type_name("NUMBER")
      .capture_default_str();
  command
      .add_option("--compaction", o->way.compaction,
                  "shear: logarithmic volume lost before, in as many steps")
      .type_name("NUMBER")
      .capture_default_str();
  command.add_option("--model", o->model, "run a vmdc or dpc card as vmdc, dpc, dpc-published or von-mises")
      .type_name("NAME");
  command.add_option("--moduli", o->way.moduli, "implicit, or after-step: elastic moduli one step late")
      .type_name("SCHEME")
      .capture_default_str();
  command.add_option("-o", o->folder, "folder for point.csv and surface.svg, instead of printing")
      .type_name("DIR");
  command.footer("Example: platen point base-case --path uniaxial-strain --strain -0.3 -o out/point");
  command.callback([o] { point(*o); });
}

} // namespace platen::app
