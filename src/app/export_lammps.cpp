#include "app/export_lammps.hpp"
#include "app/law_arguments.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "material/card.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace platen::app {
namespace {

struct Options {
  std::vector<std::string> laws; // of particle types 1, 2, ...
  std::string output, material;
  double radius = 0, density = 0, delta_bar = 0;
};

/// Twelve contacts share their stiffness among three directions, four to each, and their other ends move
/// against them: no frequency is above omega^2 = 8 k/m (Gershgorin), and central differences are stable up to
/// 2/omega. A tenth of that resolves the collision.
constexpr double safety = 0.1;

/// Largest stiffness up to `gamma`, on the loading curve and where unloading leaves it.
double stiffest(const law::Law& law, double gamma) {
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

/// The stiffest state of one type's contacts, up to the overlap `delta_bar` or the end of its card's
/// validity.
struct Stiffest {
  double delta_bar, k;
};

Stiffest stiffest_of(const fit::LawCard& card, const Options& options) {
  const law::Law law = fit::make_law(card, {{"radius_m", fmt::format("{}", options.radius)}});
  const double delta_bar = options.delta_bar > 0 ? options.delta_bar
                           : card.delta_bar      ? (*card.delta_bar)[1]
                                                 : 0;
  if (!(delta_bar > 0))
    throw core::InvalidInput(
        fmt::format("{}: the card does not say how far it holds; give --delta-bar", card.file));
  const double k = stiffest(law, delta_bar / delta_bar_per_overlap(law));
  if (!(k > 0))
    throw core::InvalidInput(
        fmt::format("{}: the law has no stiffness up to delta/R = {}", card.file, delta_bar));
  return {delta_bar, k};
}

double density_of(const Options& options) {
  if (options.material.empty()) {
    if (options.density > 0 && std::isfinite(options.density)) return options.density;
    throw core::InvalidInput(
        "--density must be a positive number of kg/m^3; or name a card that has it, with --material");
  }
  const auto card = material::read_card(options.material);
  if (!card.material.density)
    throw core::InvalidInput(
        fmt::format("{}: [parameters] has no density_kg_per_m3; add it, or give --density", card.file));
  return *card.material.density;
}

std::string lines_of(const Options& options) {
  if (!(options.radius > 0 && std::isfinite(options.radius)))
    throw core::InvalidInput("--radius must be a positive number of metres");
  const double density = density_of(options);
  const double m = density * 4 / 3 * std::numbers::pi * std::pow(options.radius, 3);
  std::string text = fmt::format("# spheres of radius {} m and {} kg/m^3\n", options.radius, density);
  std::string pairs;
  double k = 0;
  std::vector<std::string> cards;
  for (const std::string& name : options.laws) {
    const fit::LawCard card = fit::read_law_card(name);
    const auto [delta_bar, own] = stiffest_of(card, options);
    k = std::max(k, own);
    cards.push_back(std::filesystem::absolute(card.file).string());
    text += fmt::format("# type {}: law {}, stiffest state up to delta/R = {}: {:.6g} N/m\n", cards.size(),
                        card.law, delta_bar, own);
    for (std::size_t i = 0; i + 1 < cards.size(); ++i)
      pairs += fmt::format("pair_coeff {} {} {} {}\n", i + 1, cards.size(), cards[i], cards.back());
    pairs += fmt::format("pair_coeff {0} {0} {1}\n", cards.size(), cards.back());
  }
  return text +
         fmt::format("# time step: {} of the stability limit 2 sqrt(m/8k)\n"
                     "# before the box is made: units si, atom_style sphere, newton off, include platen.lmp\n"
                     "comm_modify vel yes\n"
                     "pair_style platen\n"
                     "{}timestep {:.4g}\n",
                     safety, pairs, safety * 2 * std::sqrt(m / (8 * k)));
}

} // namespace

void add_export_lammps(Command command) {
  auto lammps =
      command.add_subcommand("lammps", "input lines for pair_style platen, with a stable time step");
  auto options = std::make_shared<Options>();
  lammps.add_option("LAW", options->laws, "law cards of particle types 1, 2, ...").required();
  lammps.add_option("--radius", options->radius, "of the smallest particle [m]").required();
  auto density = lammps.add_option("--density", options->density, "of the particles [kg/m^3]");
  lammps.add_option("--material", options->material, "material card that has the density_kg_per_m3")
      .excludes(density);
  lammps.add_option("--delta-bar", options->delta_bar,
                    "largest delta/R that will be reached (default: the end of the card's validity)");
  lammps.add_option("-o", options->output, "file to write instead of printing");
  lammps.footer("Example: platen export lammps mcc.toml --radius 1e-4 --density 1500 -o mcc.lmp");
  lammps.callback([options] {
    const std::string text = lines_of(*options);
    if (options->output.empty()) fmt::print("{}", text);
    else core::write_file(options->output, text);
  });
}

} // namespace platen::app
