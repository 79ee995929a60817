#pragma once
// Equilibrium of a wedge of a sphere on its mirror planes under rigid frictionless planes.
//
// The contact pressure is integrated over the faces of the surface, of which a part can touch, and may be
// with several planes at once. It is a stiffness times the penetration, as in fe/plane_contact.hpp. A face
// lies at the mean distance of the sphere over it: faces are so large here that the sphere would rise over
// their nodes by more than the penetration, and the pressure come in waves. The unknowns are the
// displacements that the mirrors leave free, each along a direction of its node, so mirrors that are no
// coordinate planes are exact.

#include "fe/hexahedral.hpp"
#include "fe/lagged_solver.hpp"
#include "fe/plane_contact.hpp"
#include "fe/sphere_wedge.hpp"

#include <memory>

namespace platen::fe {

/// The contact of one face of the surface with a plane.
struct FacePressure {
  int face;
  double pressure; ///< mean over the face (Pa)
  double area;     ///< as it lies now (R0^2)
  double energy;   ///< of the penetration (R0^3 Pa)
  double touching; ///< share of it that penetrates
};

class WedgeContact : Equilibrium {
 public:
  /// The planes lie at `height` (R0) along their unit normals.
  WedgeContact(HexahedralSolid&, const WedgeMesh&, std::vector<Vector3> normals, NewtonSettings,
               const ContactStiffness& = {});

  int unknowns() const { return static_cast<int>(u.size()); }

  /// Solves for the planes at `heights` (R0), starting from `guess`. On success `u` is the new equilibrium
  /// and the solid holds the evaluation there, not committed; else `u` is unchanged.
  StepReport solve(const std::vector<double>& heights, std::vector<double> guess);

  /// Moves the nodes in contact with a plane at the last equilibrium by its rise: a guess for planes that
  /// turn.
  void follow(const std::vector<double>& rise, std::vector<double>& guess) const;

  /// At the last equilibrium, of a whole plane. `radius` is that of the circle with the area of the contact,
  /// `energy` that of the penetration under one plane.
  Contact contact(int plane) const;
  /// Of the wedge alone: the faces on which the plane presses.
  std::vector<FacePressure> pressures(int plane) const;

  /// Displacements (x, y, z of each node) of the last equilibrium.
  std::vector<double> displacements() const { return expand(u); }

  std::vector<double> u; ///< free displacements of the last equilibrium (R0)

 private:
  struct Point { ///< of the undeformed sphere, facing a plane
    int face;
    std::array<double, 4> N;
    double depth;           ///< of the facet below the pole
    double area;            ///< R0^2
    double flexibility;     ///< penetration at the pressure scale (R0)
    double least_stiffness; ///< pressure over penetration, where that is stiffer (Pa/R0)
    double misfit;          ///< mean height of the sphere over the face (R0)
  };
  struct Plane {
    Vector3 normal;
    int wedges = 0; ///< of the whole sphere, that press on this plane
    double height = 1;
    std::vector<Point> points; ///< 16 a face, faces that never touch left out
  };
  static constexpr int points_per_face = 16;

  std::vector<double> expand(const std::vector<double>& x) const;
  double stiffness_of(const Point&) const;
  /// Negative where the point penetrates; displacements x, y, z of each node.
  double gap(const Plane&, const Point&, const std::vector<double>& displacement) const;
  static double spread_area(const std::vector<FacePressure>&);
  double edge_area(const std::vector<FacePressure>&) const;
  Evaluation evaluate(const std::vector<double>& x, Residual&) override;
  bool linearise(const Residual&) override;
  bool solve_linear(std::span<double> rhs_to_solution) override;
  std::span<const material::PointUpdate> updates() const override { return solid.updates; }
  void number_unknowns();
  void reduce();

  struct Free {               ///< what a node may do
    int first = 0, count = 0; ///< unknowns
    std::array<Vector3, 3> along{};
  };
  struct FaceElement {
    int element;
    std::array<int, 4> corner; ///< places of the face's nodes in the element
  };

  HexahedralSolid& solid;
  const WedgeMesh& mesh;
  NewtonSettings settings;
  ContactStiffness stiffness_rule;
  std::vector<Plane> planes;
  std::vector<Free> free_of; ///< per node
  std::vector<FaceElement> face_elements;
  std::vector<char> plain;      ///< per element: all its components are unknowns
  std::vector<double> matrices; ///< of the elements, of their unknowns alone
  std::vector<double> free_force;
  std::unique_ptr<LaggedSolver> solver;
  double pressure_scale; ///< highest mean pressure met so far (Pa)
};

} // namespace platen::fe
