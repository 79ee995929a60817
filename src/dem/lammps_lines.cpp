#include "dem/lammps_lines.hpp"

#include "core/error.hpp"
#include "dem/contacts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace platen::dem {
namespace {

/// Twelve contacts share their stiffness among three directions, four to each, and their other ends move
/// against them: no frequency is above omega^2 = 8 k/m (Gershgorin), and central differences are stable up to
/// 2/omega. A tenth of that resolves the collision.
constexpr double safety = 0.1;

double mass_of(const ParticleType& t) {
  return t.density * 4 / 3 * std::numbers::pi * std::pow(t.radius_m, 3);
}

void check(const ParticleType& t) {
  const auto positive = [](double v) { return v > 0 && std::isfinite(v); };
  if (!positive(t.radius_m)) throw core::InvalidInput("the radius must be a positive number of metres");
  if (!positive(t.density)) throw core::InvalidInput("the density must be a positive number of kg/m^3");
}

/// The stiffest state of two types' contacts, up to `delta_bar` or to where cards and laws say that they
/// hold: on the loading curve, and where unloading leaves it.
struct Stiffest {
  double delta_bar = 0, k = 0;
};

Stiffest stiffest_of(const ParticleType& one, const ParticleType& two, double delta_bar) {
  Laws laws({one.card, two.card}, 0, {});
  const Laws::At at = laws.at(one.radius_m, two.radius_m);
  const double valid = std::min(laws.x_valid, at.table->valid[0][1]);
  if (!(delta_bar > 0)) delta_bar = valid;
  if (!(delta_bar > 0 && delta_bar < law::TableView::x_limit))
    throw core::InvalidInput(fmt::format("{}{}: neither card nor law says how far it holds; give --delta-bar",
                                         one.card.file, &one == &two ? "" : " with " + two.card.file));
  constexpr int points = 2000;
  Stiffest s{delta_bar};
  for (int i = 1; i <= points; ++i) {
    const double gamma = delta_bar / at.scale.x_per_gamma * i / points;
    s.k = std::max({s.k, respond(at, 0, gamma).stiffness, respond(at, gamma, gamma * (1 - 1e-6)).stiffness});
  }
  if (!(s.k > 0))
    throw core::InvalidInput(
        fmt::format("{}: the law has no stiffness up to delta/R = {}", one.card.file, delta_bar));
  return s;
}

} // namespace

std::string lammps_lines(const std::vector<ParticleType>& types, double delta_bar_asked) {
  std::string text, pairs;
  std::vector<double> stiffest(types.size());
  for (std::size_t j = 0; j < types.size(); ++j) {
    const ParticleType& t = types[j];
    check(t);
    text +=
        fmt::format("# type {}: law {}, radius {} m, {} kg/m^3\n", j + 1, t.card.law, t.radius_m, t.density);
    for (std::size_t i = 0; i <= j; ++i) {
      const auto [delta_bar, k] = stiffest_of(types[i], i == j ? types[i] : t, delta_bar_asked);
      text += fmt::format("#   with type {}: stiffest state up to delta/R = {:.6g}: {:.6g} N/m\n", i + 1,
                          delta_bar, k);
      stiffest[i] = std::max(stiffest[i], k);
      stiffest[j] = std::max(stiffest[j], k);
      pairs += i == j ? fmt::format("pair_coeff {0} {0} {1}\n", j + 1, t.path)
                      : fmt::format("pair_coeff {} {} {} {}\n", i + 1, j + 1, types[i].path, t.path);
    }
  }
  double step = law::infinity;
  for (std::size_t i = 0; i < types.size(); ++i)
    step = std::min(step, safety * 2 * std::sqrt(mass_of(types[i]) / (8 * stiffest[i])));
  if (!std::isnormal(step))
    throw core::InvalidInput("the time step of particles of this size and density is no number");
  return text +
         fmt::format("# time step: {} of the stability limit 2 sqrt(m/8k), the least of all types\n"
                     "# before the box is made: units si, atom_style sphere, newton off, include platen.lmp\n"
                     "comm_modify vel yes\n"
                     "pair_style platen\n"
                     "{}timestep {:.4g}\n",
                     safety, pairs, step);
}

} // namespace platen::dem
