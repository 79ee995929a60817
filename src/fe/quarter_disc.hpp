#pragma once
// Meridian half-section of a sphere cut at the equator: a quarter disc of quadrilaterals, refined to the
// pole.

#include <array>
#include <vector>

namespace platen::fe {

/// Quadrilaterals in the (r, z) plane; lengths in units of R0.
struct AxisymmetricMesh {
  std::vector<std::array<double, 2>> nodes;
  std::vector<std::array<int, 4>> quads; ///< counter-clockwise
  std::vector<int> surface;              ///< nodes on the sphere, from the pole to the equator
  std::vector<int> axis, equator;        ///< nodes on r = 0 and on z = 0
};

/// Unit quarter disc with about `elements` elements. The disc is a triangle with corners O (centre), P
/// (pole), E (equator), cut into three blocks that meet in its middle; sizes grow geometrically away from the
/// pole. At the sphere there are three columns of elements for one below, from 1000 elements on nine.
AxisymmetricMesh quarter_disc(int elements);

} // namespace platen::fe
