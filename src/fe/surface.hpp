#pragma once
// The sphere over the edges or faces of a mesh, in points of a quadrature.

#include "fe/mesh.hpp"

#include <vector>

namespace platen::fe {

/// A point of the undeformed sphere.
template <class Mesh> struct SurfacePoint {
  std::array<double, Mesh::face_corners> N; ///< of the displacements of the face's nodes
  Vector<Mesh::dim> X;                      ///< on the sphere, not on the face
  double area;                              ///< that it stands for (R0^2); of a section that of the ring
};

template <class Mesh> struct Surface {
  /// Eight points an edge (a ring of 2 pi), or four by four a face.
  static constexpr int points = Mesh::dim == 2 ? 8 : 16;

  explicit Surface(const Mesh&);

  struct Face {
    std::array<int, Mesh::face_corners> node;
    std::array<SurfacePoint<Mesh>, points> point;
    int element;                                ///< the one under it
    std::array<int, Mesh::face_corners> corner; ///< places of the nodes in the element
  };
  std::vector<Face> faces; ///< as Mesh::surface
};

} // namespace platen::fe
