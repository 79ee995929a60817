#pragma once
// Wedges of a sphere between mirror planes through its centre, in hexahedra.

#include "fe/mesh.hpp"

#include <array>
#include <vector>

namespace platen::fe {

/// What of the sphere is modelled: the symmetry of the planes that press it.
enum class Wedge {
  octant,      ///< 1/8: the coordinate planes
  sixteenth,   ///< 1/16: y = 0, x = y, z = 0; the same along x and y
  forty_eighth ///< 1/48: x = 0, x = y, y = z; the same along x, y and z
};

/// About `elements` hexahedra: a curved tetrahedron of the centre and three corners on the sphere, cut into
/// four blocks that meet in its middle; sizes grow geometrically away from where planes press and from the
/// sphere inward.
WedgeMesh sphere_wedge(Wedge, int elements);

/// What maps the wedge onto the whole sphere: the group that the mirrors generate, the identity first. Rows
/// of matrices.
std::vector<std::array<Vector3, 3>> copies(const WedgeMesh&);

/// Least scaled Jacobian over the corners of the elements, nodes displaced by u (x, y, z of each): 1 for a
/// cube, 0 where an edge lies in the plane of its two neighbours. `mean`: of the elements' least.
struct MeshQuality {
  double least, mean;
};
MeshQuality quality(const WedgeMesh&, const std::vector<double>& u);

} // namespace platen::fe
