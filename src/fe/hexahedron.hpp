#pragma once
// Eight-node hexahedron (fe/element.hpp).

#include "fe/element.hpp"

namespace platen::fe {

struct Hexahedron {
  using Mesh = WedgeMesh;
  static constexpr int points = 8, unknowns = 24; ///< unknowns: x, y, z of its eight nodes
  using Stress = Symmetric3;
  using Gradient = std::array<Vector3, 3>; ///< rows
  static constexpr std::array normal_components{0, 1, 2};

  struct State {
    Symmetric3 Cp_inv{1, 1, 1, 0, 0, 0};
    double phi = 0;
    bool operator==(const State&) const = default;
  };

  using Gradients = std::array<Vector3, 8>; ///< of the shape functions
  struct Shape {
    std::array<Gradients, points> N; ///< in the reference configuration
    std::array<double, points> volume;
    double whole_volume;
  };
  struct Kinematics {
    struct Point {
      Gradients grad; ///< spatial
      Gradient F;     ///< F_bar
      double J;       ///< det F, not averaged
      Spectral b;     ///< b_e^tr
    };
    std::array<Point, points> point;
    double J_bar;
  };

  static Shape shape(const std::array<Vector3, 8>& corners);
  static bool deform(const Shape&, const double* u, Kinematics&);
  static void strains(Kinematics&, const State*, PrincipalStrains*);
  static void forces(const Shape&, const Kinematics&, const material::PointUpdate*, double* force);
  static void tangent(const Shape&, const Kinematics&, const material::PointUpdate*, double two_G_added,
                      double* K);
  static State updated(const Kinematics&, int point, const material::PointUpdate&);
  static Stress cauchy(const Kinematics&, int point, const material::PointUpdate&);
  static Gradient gradient(const Kinematics& moved, int point) { return moved.point[point].F; }
  static Stress turned(const Stress&, const Gradient& from, const Gradient& to);
  static State continued(const State&, const State&, double factor);
  static double contraction(const Stress&, const Stress&);
  static PrincipalStrains plastic_strain(const State&);
};

} // namespace platen::fe
