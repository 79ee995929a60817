#pragma once
// Any two bodies as one sphere on a rigid flat (pair.hpp): what most laws for metals were found for.
//   R = R_e,   E = E* A R_e,   delta = x R_e
// Two equal spheres have R their radius, E = E1/(1 - nu1^2) and delta = gamma/2; Hertz's force is the same
// for any two bodies. Their force law, applied to two equal spheres with 1/A, E* and the whole gamma, agrees.

#include "platen/law/pair.hpp"

namespace platen::law {

struct RigidFlat {
  double R = 0;               ///< [m]
  double E = 0;               ///< modulus E' of the sphere's side [Pa]
  double delta_per_gamma = 1; ///< [-]
};

inline RigidFlat as_rigid_flat(const Pair& pair) {
  return {pair.R_e, pair.E_star * pair.sharing(), pair.R_e * pair.x_per_gamma};
}

} // namespace platen::law
