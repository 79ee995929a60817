#include "app/export_lammps.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "dem/contacts.hpp"
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
  std::vector<std::string> materials;
  std::vector<double> radii, densities; // of each type, or one for all
  std::string output;
  double delta_bar = 0;
};

/// Twelve contacts share their stiffness among three directions, four to each, and their other ends move
/// against them: no frequency is above omega^2 = 8 k/m (Gershgorin), and central differences are stable up to
/// 2/omega. A tenth of that resolves the collision.
constexpr double safety = 0.1;

/// What a type of particles is.
struct Type {
  fit::LawCard card;
  double radius = 0, density = 0;
  [[nodiscard]] double mass() const { return density * 4 / 3 * std::numbers::pi * std::pow(radius, 3); }
};

template <class T> const T& of_type(const std::vector<T>& values, std::size_t type) {
  return values.size() == 1 ? values.front() : values[type];
}

double density_in(const std::string& material) {
  const auto card = material::read_card(material);
  if (!card.material.density)
    throw core::InvalidInput(
        fmt::format("{}: [parameters] has no density_kg_per_m3; add it, or give --density", card.file));
  return *card.material.density;
}

std::vector<Type> types_of(const Options& o) {
  const auto for_each_type = [&](std::size_t given, const char* option) {
    if (given > 1 && given != o.laws.size())
      throw core::InvalidInput(
          fmt::format("{} is given {} times, and there are {} law cards: give it once for "
                      "all types or once for each",
                      option, given, o.laws.size()));
  };
  for_each_type(o.radii.size(), "--radius");
  for_each_type(o.densities.size(), "--density");
  for_each_type(o.materials.size(), "--material");
  if (o.densities.empty() && o.materials.empty())
    throw core::InvalidInput(
        "--density must be a positive number of kg/m^3; or name a card that has it, with --material");
  std::vector<Type> types;
  for (std::size_t i = 0; i < o.laws.size(); ++i) {
    Type t{fit::read_law_card(o.laws[i]), of_type(o.radii, i)};
    t.density = o.materials.empty() ? of_type(o.densities, i) : density_in(of_type(o.materials, i));
    if (!(t.radius > 0 && std::isfinite(t.radius)))
      throw core::InvalidInput("--radius must be a positive number of metres");
    if (!(t.density > 0 && std::isfinite(t.density)))
      throw core::InvalidInput("--density must be a positive number of kg/m^3");
    types.push_back(std::move(t));
  }
  return types;
}

/// The stiffest state of two types' contacts, up to `delta_bar` or to where cards and laws say that they
/// hold: on the loading curve, and where unloading leaves it.
struct Stiffest {
  double delta_bar = 0, k = 0;
};

Stiffest stiffest_of(const Type& one, const Type& two, double delta_bar) {
  dem::Laws laws({one.card, two.card}, 0, {});
  const dem::Laws::At at = laws.at(one.radius, two.radius);
  const double valid = std::min(laws.x_valid, at.table->valid[0][1]);
  if (!(delta_bar > 0)) delta_bar = valid;
  if (!(delta_bar > 0 && delta_bar < law::TableView::x_limit))
    throw core::InvalidInput(fmt::format("{}{}: neither card nor law says how far it holds; give --delta-bar",
                                         one.card.file, &one == &two ? "" : " with " + two.card.file));
  constexpr int points = 2000;
  Stiffest s{delta_bar};
  for (int i = 1; i <= points; ++i) {
    const double gamma = delta_bar / at.scale.x_per_gamma * i / points;
    s.k = std::max(
        {s.k, dem::respond(at, 0, gamma).stiffness, dem::respond(at, gamma, gamma * (1 - 1e-6)).stiffness});
  }
  if (!(s.k > 0))
    throw core::InvalidInput(
        fmt::format("{}: the law has no stiffness up to delta/R = {}", one.card.file, delta_bar));
  return s;
}

std::string lines_of(const Options& options) {
  const std::vector<Type> types = types_of(options);
  std::string text, pairs;
  std::vector<double> stiffest(types.size());
  for (std::size_t j = 0; j < types.size(); ++j) {
    const Type& t = types[j];
    text +=
        fmt::format("# type {}: law {}, radius {} m, {} kg/m^3\n", j + 1, t.card.law, t.radius, t.density);
    for (std::size_t i = 0; i <= j; ++i) {
      const auto [delta_bar, k] = stiffest_of(types[i], i == j ? types[i] : t, options.delta_bar);
      text += fmt::format("#   with type {}: stiffest state up to delta/R = {:.6g}: {:.6g} N/m\n", i + 1,
                          delta_bar, k);
      stiffest[i] = std::max(stiffest[i], k);
      stiffest[j] = std::max(stiffest[j], k);
      const auto path = [](const Type& of) { return std::filesystem::absolute(of.card.file).string(); };
      pairs += i == j ? fmt::format("pair_coeff {0} {0} {1}\n", j + 1, path(t))
                      : fmt::format("pair_coeff {} {} {} {}\n", i + 1, j + 1, path(types[i]), path(t));
    }
  }
  double step = law::infinity;
  for (std::size_t i = 0; i < types.size(); ++i)
    step = std::min(step, safety * 2 * std::sqrt(types[i].mass() / (8 * stiffest[i])));
  return text +
         fmt::format("# time step: {} of the stability limit 2 sqrt(m/8k), the least of all types\n"
                     "# before the box is made: units si, atom_style sphere, newton off, include platen.lmp\n"
                     "comm_modify vel yes\n"
                     "pair_style platen\n"
                     "{}timestep {:.4g}\n",
                     safety, pairs, step);
}

} // namespace

void add_export_lammps(Command command) {
  auto lammps =
      command.add_subcommand("lammps", "input lines for pair_style platen, with a stable time step");
  auto options = std::make_shared<Options>();
  lammps.add_option("LAW", options->laws, "law cards of particle types 1, 2, ...").required();
  lammps
      .add_option("--radius", options->radii, "of the smallest particle [m]; one for all types, or one each")
      .required();
  auto density = lammps.add_option("--density", options->densities,
                                   "of the particles [kg/m^3]; one for all types, or one each");
  lammps
      .add_option("--material", options->materials,
                  "material card that has the density_kg_per_m3; one for all types, or one each")
      .excludes(density);
  lammps.add_option("--delta-bar", options->delta_bar,
                    "largest delta/R that will be reached (default: as far as card and law hold)");
  lammps.add_option("-o", options->output, "file to write instead of printing");
  lammps.footer("Example: platen export lammps mcc.toml --radius 1e-4 --density 1500 -o mcc.lmp");
  lammps.callback([options] {
    const std::string text = lines_of(*options);
    if (options->output.empty()) fmt::print("{}", text);
    else core::write_file(options->output, text);
  });
}

} // namespace platen::app
