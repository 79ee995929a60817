#include "app/export_lammps.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/number.hpp"
#include "dem/lammps_lines.hpp"
#include "material/card.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace platen::app {
namespace {

struct Options {
  std::vector<std::string> laws; // of particle types 1, 2, ...
  std::vector<std::string> materials;
  std::vector<double> radii, densities; // of each type, or one for all
  std::string output;
  std::optional<double> delta_bar;
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

std::vector<dem::ParticleType> types_of(const Options& o) {
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
  std::vector<dem::ParticleType> types;
  for (std::size_t i = 0; i < o.laws.size(); ++i) {
    dem::ParticleType t{fit::read_law_card(o.laws[i]), of_type(o.radii, i)};
    t.path = std::filesystem::absolute(t.card.file).string();
    t.density = o.materials.empty() ? of_type(o.densities, i) : density_in(of_type(o.materials, i));
    types.push_back(std::move(t));
  }
  return types;
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
    const auto& asked = options->delta_bar;
    if (asked && !(*asked > 0 && *asked <= 1))
      throw core::InvalidInput(
          fmt::format("--delta-bar {}: it must be a number in (0, 1]", core::number_text(*asked)));
    const std::string text = dem::lammps_lines(types_of(*options), asked.value_or(0));
    if (options->output.empty()) fmt::print("{}", text);
    else core::write_file(options->output, text);
  });
}

} // namespace platen::app
