#pragma once
// Input lines for pair_style platen of LAMMPS, with a stable time step.

#include "fit/law_card.hpp"

#include <string>
#include <vector>

namespace platen::dem {

struct ParticleType {
  fit::LawCard card;
  double radius_m = 0;   ///< of the smallest
  double density = 0;    ///< kg/m^3
  std::string path = {}; ///< where LAMMPS finds the card
};

/// Cards of particle types 1, 2, ..., which LAMMPS reads again. The time step is stable for
/// every pair of types up to `delta_bar`, the largest delta/R that will be reached; 0: as far as cards and
/// laws hold. InvalidInput where nothing says how far, where a law has no stiffness, and for two cards that
/// the plug-in would refuse.
std::string lammps_lines(const std::vector<ParticleType>&, double delta_bar = 0);

} // namespace platen::dem
