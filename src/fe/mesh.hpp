#pragma once
// What a mesh of a sphere, or of its part between mirrors, consists of. Lengths in units of R0.

#include "fe/tensor.hpp"

#include <array>
#include <vector>

namespace platen::fe {

/// Mirrors are planes of symmetry through the centre of the sphere; nodes on them stay on them.
template <int dim_, int corners_, int face_corners_> struct Mesh {
  static constexpr int dim = dim_, corners = corners_, face_corners = face_corners_;
  struct Mirror {
    Vector<dim> normal;     ///< unit
    std::vector<int> nodes; ///< on it
  };
  std::vector<Vector<dim>> nodes;
  std::vector<std::array<int, corners>> elements;
  std::vector<std::array<int, face_corners>> surface; ///< edges or faces on the sphere
  std::vector<Mirror> mirrors;
};

/// Meridian half-section in the (r, z) plane: quadrilaterals, counter-clockwise; edges from the pole to the
/// equator.
using SectionMesh = Mesh<2, 4, 2>;
/// Hexahedra, bottom counter-clockwise seen from the top, then the top; faces counter-clockwise from outside.
using WedgeMesh = Mesh<3, 8, 4>;

} // namespace platen::fe
