#pragma once
// Equilibrium of a half sphere on its equator plane under a rigid frictionless plane z = height.
//
// The contact pressure is integrated along the edges of the surface, over the true sphere: a point between
// two nodes lies at its place on the undeformed sphere plus the interpolated displacement, and a part of an
// edge can touch. (With exact contact of nodes the radius grows by whole edges, and with it, in scallops, the
// force of a plastic sphere.) The pressure is a stiffness times the penetration, the same for every mesh: at
// the highest mean pressure met so far, a point at distance s from the pole penetrates by 0.001 s^2/R0
// (unless asked otherwise), about 0.2 % of the delta at which the contact gets there; by less where the
// material is so stiff that it springs back by little more than that.

#include "fe/axisymmetric.hpp"
#include "fe/newton.hpp"
#include "fe/sparse.hpp"

#include <vector>

namespace platen::fe {

/// How stiff the contact is.
struct ContactStiffness {
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
  /// Between its nodes the surface is then a chord at the sphere's mean distance, since the arc would rise
  /// over its chord by more than the penetration, and the pressure come in waves.
  bool uniform = false;
};

/// Where the sphere touches the plane.
struct Contact {
  double force = 0;         ///< compression positive (R0^2 Pa)
  double radius = 0;        ///< R0, located inside an edge
  double peak_pressure = 0; ///< mean over an edge (Pa)
  double energy = 0;        ///< of the penetration (R0^3 Pa)
};

/// The element under an edge of the surface.
struct EdgeElement {
  int element;
  std::array<int, 2> corner; ///< places of the edge's nodes in the element
};

/// The contact pressure between two radii, its mean there.
struct PressureRing {
  double inner, outer; ///< R0, current
  double pressure;     ///< Pa, 0 beyond the contact
};

class PlaneContact : Equilibrium {
 public:
  PlaneContact(AxisymmetricSolid&, NewtonSettings, const ContactStiffness& = {});

  /// Solves for the plane at `height` (R0), starting from `guess`. On success `u` is the new equilibrium and
  /// the solid holds the evaluation there, not committed; else `u` is unchanged.
  StepReport solve(double height, std::vector<double> guess);

  /// Moves the nodes in contact at the last equilibrium by `rise` along the axis: a guess for a plane that
  /// turns.
  void follow(double rise, std::vector<double>& guess) const;

  Contact contact() const; ///< at the last equilibrium
  /// One ring an edge at the last equilibrium, from the pole to the first edge that is free.
  std::vector<PressureRing> pressure_profile() const;

  std::vector<double> u; ///< last equilibrium (R0)

 private:
  static constexpr int points_per_edge = 8;
  struct EdgePoint { ///< of the undeformed sphere
    std::array<double, 2> N;
    double r;               ///< sphere less chord: what the displacement of the nodes does not interpolate
    double depth;           ///< below the pole; by itself, since near the pole 1 - z would be rounding
    double area;            ///< 2 pi included
    double flexibility;     ///< penetration at the pressure scale (R0)
    double least_stiffness; ///< pressure over penetration, where that is stiffer (Pa/R0)
  };
  double stiffness_of(const EdgePoint&) const;
  double height_above_plane(const EdgePoint&, int edge, const std::vector<double>& x) const;
  double radius(const EdgePoint&, int edge) const;
  void locate_edge(Contact&) const;
  Evaluation evaluate(const std::vector<double>& x, Residual&) override;
  bool linearise(const Residual&) override;
  bool solve_linear(std::span<double> rhs_to_solution) override;
  std::span<const material::PointUpdate> updates() const override { return solid.updates; }

  AxisymmetricSolid& solid;
  NewtonSettings settings;
  DirectSolver solver;
  std::vector<char> fixed;                           ///< unknowns on the axis and the equator
  std::vector<std::array<int, 2>> fixed_in_elements; ///< an element with one of them, its row there
  std::vector<std::array<EdgePoint, points_per_edge>> edges;
  std::vector<EdgeElement> edge_elements;
  double height = 1;
  double pressure_scale; ///< highest mean pressure met so far (Pa)
  ContactStiffness stiffness_rule;
  double largest_radius = 0; ///< of the contacts met so far (R0)
};

} // namespace platen::fe
