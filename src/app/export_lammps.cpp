#include "app/export_lammps.hpp"
#include "app/law_arguments.hpp"
#include "core/error.hpp"
#include "core/file.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>

namespace platen::app {
namespace {

struct Options {
  std::string law, output;
  double radius = 0, density = 0, delta_bar = 0;
};

/// Twelve contacts share their stiffness among three directions, four to each, and their other ends move
/// against them: no frequency is above omega^2 = 8 k/m (Gershgorin), and central differences are stable up to
/// 2/omega. A tenth of that resolves the collision.
constexpr double safety = 0.1;

/// Largest stiffness up to `gamma`, on the loading curve and where unloading leaves it.
double stiffest(const law::AnyLaw& law, double gamma) {
  constexpr int points = 2000;
  double k = 0;
  for (int i = 1; i <= points; ++i) {
    const double at = gamma * i / points;
    const auto here = law::evaluate(law, {}, at);
    const auto back = law::evaluate(law, here.state, at * (1 - 1e-6));
    k = std::max({k, here.stiffness, back.stiffness});
  }
  return k;
}

std::string lines_of(const Options& options) {
  if (!(options.radius > 0 && std::isfinite(options.radius)))
    throw core::InvalidInput("--radius must be a positive number of metres");
  if (!(options.density > 0 && std::isfinite(options.density)))
    throw core::InvalidInput("--density must be a positive number of kg/m^3");
  const fit::LawCard card = fit::read_law_card(options.law);
  const auto R = fmt::format("{}", options.radius);
  const law::AnyLaw law = fit::make_law(card, {{"radius_m", R}});
  const double delta_bar = options.delta_bar > 0 ? options.delta_bar
                           : card.delta_bar      ? (*card.delta_bar)[1]
                                                 : 0;
  if (!(delta_bar > 0))
    throw core::InvalidInput(
        fmt::format("{}: the card does not say how far it holds; give --delta-bar", options.law));
  const double gamma = delta_bar / delta_bar_per_overlap(law);
  const double m = options.density * 4 / 3 * std::numbers::pi * std::pow(options.radius, 3);
  const double k = stiffest(law, gamma);
  if (!(k > 0))
    throw core::InvalidInput(
        fmt::format("{}: the law has no stiffness up to delta/R = {}", card.file, delta_bar));
  const double dt = safety * 2 * std::sqrt(m / (8 * k));
  return fmt::format(
      "# law {}, spheres of radius {} m and {} kg/m^3\n"
      "# stiffest state up to delta/R = {}: {:.6g} N/m; time step: {} of the stability limit 2 sqrt(m/8k)\n"
      "# before the box is made: units si, atom_style sphere, newton off, include platen.lmp\n"
      "comm_modify vel yes\n"
      "pair_style platen\n"
      "pair_coeff * * {}\n"
      "timestep {:.4g}\n",
      card.law, options.radius, options.density, delta_bar, k, safety,
      std::filesystem::absolute(card.file).string(), dt);
}

} // namespace

void add_export_lammps(CLI::App& command) {
  auto* lammps =
      command.add_subcommand("lammps", "input lines for pair_style platen, with a stable time step");
  auto options = std::make_shared<Options>();
  lammps->add_option("LAW", options->law, "law card")->required();
  lammps->add_option("--radius", options->radius, "of the smallest particle [m]")->required();
  lammps->add_option("--density", options->density, "of the particles [kg/m^3]")->required();
  lammps->add_option("--delta-bar", options->delta_bar,
                     "largest delta/R that will be reached (default: the end of the card's validity)");
  lammps->add_option("-o", options->output, "file to write instead of printing");
  lammps->footer("Example: platen export lammps mcc.toml --radius 1e-4 --density 1500 -o mcc.lmp");
  lammps->callback([options] {
    const std::string text = lines_of(*options);
    if (options->output.empty()) fmt::print("{}", text);
    else core::write_file(options->output, text);
  });
}

} // namespace platen::app
