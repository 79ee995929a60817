#pragma once
// Meridian half-section of a sphere cut at the equator: a quarter disc of quadrilaterals, refined to the
// pole.

#include "fe/mesh.hpp"

namespace platen::fe {

/// Unit quarter disc with about `elements` elements. The disc is a triangle with corners O (centre), P
/// (pole), E (equator), cut into three blocks that meet in its middle; sizes grow geometrically away from the
/// pole. At the sphere there are three columns of elements for one below, from 1000 elements on nine.
/// Mirrors: the axis r = 0 and the equator z = 0.
SectionMesh quarter_disc(int elements);

} // namespace platen::fe
