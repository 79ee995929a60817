#include "material/point.hpp"
#include "app/commands.hpp"
#include "app/output_folder.hpp"
#include "core/csv.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/nearest.hpp"
#include "core/number.hpp"
#include "material/card.hpp"
#include "material/yield_curve.hpp"
#include "plot/yield_picture.hpp"
#include "plot/zone_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>
#include <memory>

namespace platen::app {
namespace {

using material::MaterialPoint, material::ModuliScheme;
using Strains = std::array<double, 3>;

struct Options {
  std::string card, path, folder, model, moduli = "implicit";
  double strain = -0.2, lateral_Pa = 0, compaction = 0;
  int steps = 100;
};

const std::vector<std::string> paths = {"isotropic", "uniaxial-strain", "triaxial", "shear"};

void check(const Options& o) {
  const auto refuse = [](const std::string& what) { throw core::InvalidInput(what); };
  if (!(std::abs(o.strain) > 0 && std::abs(o.strain) <= 3))
    refuse(
        fmt::format("--strain {}: it must be a number in [-3, 3] other than 0", core::number_text(o.strain)));
  if (!std::isfinite(o.lateral_Pa)) refuse("--lateral_Pa must be a finite number");
  if (!(o.compaction >= 0 && o.compaction <= 3))
    refuse(fmt::format("--compaction {}: it must be a number in [0, 3]", core::number_text(o.compaction)));
  if (o.steps < 1 || o.steps > 1000000)
    refuse(fmt::format("--steps {}: it must be a whole number in [1, 1000000]", o.steps));
  if (o.moduli != "implicit" && o.moduli != "after-step")
    refuse(fmt::format("--moduli {}: it must be implicit or after-step", o.moduli));
}

/// The strain increments of a path by name or file.
std::vector<Strains> increments(const Options& o) {
  const auto even = [&](Strains whole) {
    for (double& eps : whole) eps /= o.steps;
    return std::vector<Strains>(static_cast<std::size_t>(o.steps), whole);
  };
  const double third = o.strain / 3;
  if (o.path == "isotropic") return even({third, third, third});
  if (o.path == "uniaxial-strain") return even({o.strain, 0, 0});
  if (o.path == "shear") {
    auto all = even({-o.compaction / 3, -o.compaction / 3, -o.compaction / 3});
    if (o.compaction == 0) all.clear();
    const auto shear = even({o.strain, -o.strain, 0});
    all.insert(all.end(), shear.begin(), shear.end());
    return all;
  }
  if (!std::filesystem::is_regular_file(o.path))
    throw core::InvalidInput(
        fmt::format("--path {}: neither a path{} nor a file", o.path, core::suggestion(o.path, paths)));
  const auto csv = core::read_csv(o.path);
  const std::array columns{csv.column("eps_1"), csv.column("eps_2"), csv.column("eps_3")};
  std::vector<Strains> all;
  Strains before{};
  for (const auto& row : csv.rows) {
    Strains here, step;
    for (std::size_t A = 0; A < 3; ++A) {
      here[A] = csv.number(row, columns[A]);
      step[A] = here[A] - before[A];
    }
    all.push_back(step);
    before = here;
  }
  if (all.empty()) throw core::InvalidInput(o.path + ": there is no row below the header");
  return all;
}

struct Walk {
  std::vector<MaterialPoint> points; ///< the start first
  std::string refusal;               ///< why the path ends early
};

Walk walk(const material::Model& model, const Options& o) {
  const auto scheme = o.moduli == "implicit" ? ModuliScheme::implicit : ModuliScheme::after_step;
  Walk w{{MaterialPoint{}}, ""};
  const auto take = [&](const MaterialPoint& next) {
    if (material::is_refused(next.last.status)) {
      w.refusal =
          fmt::format("step {} was refused: {}", w.points.size(),
                      next.last.status == material::Status::unstable
                          ? "densification raises the elastic stress faster than the surface gives way"
                          : "no admissible state was found; try more steps");
      return false;
    }
    w.points.push_back(next);
    return true;
  };
  if (o.path == "triaxial") {
    // The lateral stress first, all around, then the axis.
    const double bulk = material::initial_E(model) / (3 * (1 - 2 * material::initial_nu(model)));
    const double first = o.lateral_Pa / (3 * bulk);
    if (o.lateral_Pa != 0 &&
        !take(material::strained_axially(model, w.points.back(), first, o.lateral_Pa, scheme)))
      return w;
    for (int i = 0; i < o.steps; ++i)
      if (!take(material::strained_axially(model, w.points.back(), o.strain / o.steps, o.lateral_Pa, scheme)))
        return w;
    return w;
  }
  for (const Strains& step : increments(o))
    if (!take(material::strained(model, w.points.back(), step, scheme))) return w;
  return w;
}

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

/// The surface at up to five states of the path, evenly apart.
void draw(const material::Material& m, const Options& o, const Walk& w, const std::filesystem::path& file) {
  plot::StressPath path;
  double p_low = 0, p_high = 0, phi_first = 0, phi_last = 0;
  for (const auto& point : w.points) {
    path.p_q.push_back({point.last.p, point.last.q});
    path.zones.push_back(point.last.zone);
    p_low = std::min(p_low, point.last.p), p_high = std::max(p_high, point.last.p);
    phi_first = std::min(phi_first, point.phi), phi_last = std::max(phi_last, point.phi);
  }
  const double size = material::reference_stress(m.model);
  p_low -= 0.2 * (p_high - p_low) + (std::holds_alternative<material::Elastic>(m.model) ? 0 : size);
  const bool porous =
      std::holds_alternative<material::Vmdc>(m.model) || std::holds_alternative<material::Dpc>(m.model);
  const auto* metal = std::get_if<material::VonMises>(&m.model);
  const bool evolves =
      porous || (metal && !std::holds_alternative<material::PerfectlyPlastic>(metal->hardening));
  const int states = evolves && phi_last > phi_first ? 5 : 1;
  std::vector<plot::NamedCurve> curves;
  for (int i = 0; i < states; ++i) {
    const double phi = states == 1 ? 0 : phi_first + (phi_last - phi_first) * i / (states - 1);
    for (const auto& curve : material::yield_curves(m.model, phi, p_low, p_high)) {
      const std::string state = porous ? fmt::format("ρᵣ = {:.3g}", material::relative_density(m.model, phi))
                                : evolves ? fmt::format("εₚ = {:.3g}", phi)
                                          : "yield";
      curves.push_back({curve.name.empty() ? state : curve.name, curve.p_q});
    }
  }
  const bool named = std::find(paths.begin(), paths.end(), o.path) != paths.end();
  plot::yield_picture(curves, path,
                      fmt::format("{} ({}): {}", m.name, material::model_name(m.model),
                                  named ? o.path : std::filesystem::path(o.path).filename().string()),
                      file);
}

void point(const Options& o) {
  check(o);
  material::Material m = material::read_card(o.card).material;
  if (!o.model.empty()) m.model = material::run_as(m.model, o.model);
  const Walk w = walk(m.model, o);
  const std::string csv = csv_of(m.model, w);
  if (o.folder.empty()) fmt::print("{}", csv);
  else {
    const OutputFolder folder(o.folder);
    folder.forget({"point.csv", "surface.svg"});
    core::write_file(folder / "point.csv", csv);
    draw(m, o, w, folder / "surface.svg");
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
      .add_option("--path", o->path,
                  "isotropic, uniaxial-strain, triaxial, shear, or a CSV with eps_1,eps_2,eps_3")
      .required()
      .type_name("PATH");
  command
      .add_option("--strain", o->strain,
                  "logarithmic strain at the end, extension positive: of the volume (isotropic), of axis 1")
      .type_name("NUMBER")
      .capture_default_str();
  command.add_option("--steps", o->steps, "increments").type_name("NUMBER").capture_default_str();
  command.add_option("--lateral_Pa", o->lateral_Pa, "triaxial: stress on axes 2 and 3, tension positive")
      .type_name("NUMBER")
      .capture_default_str();
  command.add_option("--compaction", o->compaction, "shear: logarithmic volume lost before, in as many steps")
      .type_name("NUMBER")
      .capture_default_str();
  command.add_option("--model", o->model, "run a vmdc or dpc card as vmdc, dpc, dpc-published or von-mises")
      .type_name("NAME");
  command.add_option("--moduli", o->moduli, "implicit, or after-step: elastic moduli one step late")
      .type_name("SCHEME")
      .capture_default_str();
  command.add_option("-o", o->folder, "folder for point.csv and surface.svg, instead of printing")
      .type_name("DIR");
  command.footer("Example: platen point base-case --path uniaxial-strain --strain -0.3 -o out/point");
  command.callback([o] { point(*o); });
}

} // namespace platen::app
