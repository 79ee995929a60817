#pragma once
// Quarter disc for a small contact at the pole: the size of the elements grows in proportion to their
// distance from the pole, so that one mesh serves every contact radius between two decades apart.

#include "fe/mesh.hpp"

namespace platen::fe {

struct ContactGrid {
  double first_radius = 0.002; ///< contact radius (R0) from which on `columns` edges lie under the contact
  double last_radius = 0.06;   ///< elements grow faster beyond this distance from the pole (R0), <= 0.3
  int columns = 20;            ///< edges under the first contact radius, >= 8
};

/// Rings around the pole. Inside first_radius the elements are alike, first_radius/columns in size; from
/// there to last_radius a ring is 1/columns of its distance from the pole, beyond it up to 1/6, and the last
/// rows flatten into the equator.
SectionMesh contact_disc(const ContactGrid&);

} // namespace platen::fe
