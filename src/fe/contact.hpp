#pragma once
// Rigid frictionless planes on a sphere.
//
// The contact pressure is integrated over the true sphere above the edges or faces of the surface: a point
// between nodes lies at its place on the undeformed sphere plus the interpolated displacement, and a part of
// a face can touch, several planes at once. (With exact contact of nodes the radius grows by whole edges, and
// with it, in scallops, the force of a plastic sphere.) The pressure is a stiffness times the penetration,
// the same for every mesh: at the highest mean pressure met so far, a point at distance s from the pole
// penetrates by 0.001 s^2/R0 (unless asked otherwise), about 0.2 % of the delta at which the contact gets
// there; by less where the material is so stiff that it springs back by little more than that.
//
// Nothing here changes what it is given: what a contact remembers is a value of its caller.

#include "fe/surface.hpp"
#include "material/models.hpp"

#include <span>
#include <vector>

namespace platen::fe {

/// How stiff the contact is.
struct ContactRule {
  /// Penetration at the highest mean pressure (R0), over the square of the distance to the pole (R0).
  double relative_penetration = 0.001;
  /// Least stiffness of the contact times the distance to the pole, over E. A flat punch of radius a on a
  /// half-space springs back by (pi/2)(1 - nu^2) a p/E: the penetration by less than a hundredth of that, or
  /// stiff material would seem to unload too softly.
  double elastic = 100;
  /// Distance to the pole below which the contact gets no stiffer (R0), well inside the smallest contact of
  /// interest.
  double pole = 0.03;
  /// For contacts of few edges: everywhere elastic E/a, where a is the largest contact radius met (>= pole).
  bool uniform = false;
  /// Where the sphere would rise over a face by more than the penetration, and the pressure come in waves: a
  /// face lies at the sphere's mean distance, and is no stiffer than lets it take the sphere's place.
  bool flat_faces = false;
};

/// What planes have met so far.
struct ContactMemory {
  double pressure_scale; ///< highest mean pressure (Pa)
  double largest_radius; ///< R0
};

/// Where the sphere touches a plane, the whole of it.
struct ContactPatch {
  double force = 0;         ///< compression positive (R0^2 Pa)
  double radius = 0;        ///< R0, located inside an edge; of a face that of the circle of the same area
  double peak_pressure = 0; ///< mean over an edge or face (Pa)
  double energy = 0;        ///< of the penetration (R0^3 Pa)
};

/// The contact of one edge (its ring) or face with a plane.
struct FacePressure {
  int face;
  double pressure;             ///< mean (Pa)
  double area;                 ///< as it lies now (R0^2)
  double energy;               ///< of the penetration (R0^3 Pa)
  double touching;             ///< share of it that penetrates
  double inner = 0, outer = 0; ///< of a ring: its radii now (R0)
  double reach = 0;            ///< of a ring: where it leaves the plane, or its last point if nowhere (R0)
};

template <class Mesh> class Contact {
 public:
  static constexpr int dim = Mesh::dim;

  /// Planes along unit normals; `copies`: how many copies of the mesh press on each.
  Contact(const Mesh&, std::vector<Vector<dim>> normals, std::vector<int> copies, const ContactRule&,
          const material::Model&);

  int planes() const { return static_cast<int>(list.size()); }
  /// Before anything has touched: Hertz's mean pressure at a contact radius of `pole`.
  ContactMemory memory() const { return {first_pressure, 0}; }
  /// With what the planes meet at an equilibrium.
  ContactMemory extended(ContactMemory, std::span<const ContactPatch>, std::span<const double> heights) const;

  /// Adds the contact's forces to those on the displacement components; planes at `heights` (R0) along their
  /// normals. `touching`: per point of each plane.
  void add_forces(std::span<const double> u, std::span<const double> heights, const ContactMemory&,
                  std::span<double> force, std::vector<char>& touching) const;
  /// Adds to the element matrices of the components.
  void add_tangent(const std::vector<char>& touching, const ContactMemory&, std::span<double> matrices) const;

  /// Faces on which a plane presses, of the mesh alone; edges from the pole outwards.
  std::vector<FacePressure> pressures(int plane, std::span<const double> u, double height,
                                      const ContactMemory&) const;
  ContactPatch patch(int plane, std::span<const double> u, double height, const ContactMemory&) const;
  /// Nodes of faces that touch the plane.
  std::vector<int> nodes_touching(int plane, std::span<const double> u, double height) const;

 private:
  struct Point {            ///< of a face, facing a plane
    double depth;           ///< of the sphere, or of the face in its place, below the pole (R0)
    double flexibility;     ///< penetration at the pressure scale (R0)
    double least_stiffness; ///< pressure over penetration, where that is stiffer (Pa/R0)
    double misfit;          ///< of a flat face: mean height of the sphere over it (R0), else 0
  };
  struct Plane {
    Vector<dim> normal;
    int copies;
    std::vector<int> faces;    ///< those that may ever touch
    std::vector<Point> points; ///< Surface::points a face
  };
  double stiffness(const Point&, double area, const ContactMemory&) const;
  double gap(const Plane&, const Point&, int face, int i, std::span<const double> u, double height) const;
  Vector<dim> now(int node, std::span<const double> u) const;
  double area_of(const std::vector<FacePressure>&) const;
  double spread_area(const std::vector<FacePressure>&) const;
  double edge_area(const std::vector<FacePressure>&) const;

  const Mesh& mesh;
  const Surface<Mesh> surface;
  const ContactRule rule;
  double E, first_pressure;
  std::vector<Plane> list;
};

} // namespace platen::fe
