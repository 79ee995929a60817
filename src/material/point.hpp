#pragma once
// One material point led along a path in its principal axes.

#include "material/update.hpp"

#include <array>

namespace platen::material {

struct MaterialPoint {
  std::array<double, 3> total{};   ///< principal logarithmic strains since the start
  std::array<double, 3> elastic{}; ///< their elastic part
  double phi = 0;                  ///< state
  PointUpdate last{};              ///< the last update; zero before the first
};

/// Moduli at the state after the step, solved for with it; or at the state before it.
enum class ModuliScheme { implicit, after_step };

/// The point after one increment of its principal strains. Its `last.status` may be a refusal.
[[nodiscard]] MaterialPoint strained(const Model&, const MaterialPoint&,
                                     const std::array<double, 3>& increment,
                                     ModuliScheme = ModuliScheme::implicit);

/// The point after an increment of the first principal strain, the two others such that the stress along them
/// is `lateral` (Pa). Its `last.status` is `refused` also where no such strain was found.
[[nodiscard]] MaterialPoint strained_axially(const Model&, const MaterialPoint&, double increment,
                                             double lateral, ModuliScheme = ModuliScheme::implicit);

} // namespace platen::material
