#pragma once
// Four-node quadrilateral of a solid of revolution (fe/element.hpp). The factor 2 pi is in its volumes.

#include "fe/element.hpp"

namespace platen::fe {

struct Quad {
  using Mesh = SectionMesh;
  static constexpr int points = 4, unknowns = 8; ///< unknowns: r and z of its four nodes
  using Stress = std::array<double, 4>;          ///< rr, zz, rz, tt
  using Gradient = std::array<double, 4>;        ///< rr, rz, zr, zz; its tt turns nothing
  static constexpr std::array normal_components{0, 1, 3};

  struct State {
    std::array<double, 4> Cp_inv{1, 1, 0, 1}; ///< rr, zz, rz, tt in the reference section
    double phi = 0;
    bool operator==(const State&) const = default;
  };

  /// The four Gauss points side by side, for processors that take four numbers at a time.
  using Points = std::array<double, points>;
  struct Shape { ///< in the reference section
    std::array<Points, 4> N_R, N_Z, N_over_R;
    Points volume;
    double whole_volume;
  };
  struct Kinematics {
    std::array<Points, 4> N_r, N_z, N_over_r; ///< spatial gradients
    Points rr, rz, zr, zz, tt;                ///< F_bar
    Points J;                                 ///< det F, not averaged
    double J_bar;
    PlaneSpectralOf<Points> b; ///< b_e^tr in the section

    PlaneSpectral axes(int point) const {
      return {b.value_1[point], b.value_2[point], b.cos[point], b.sin[point]};
    }
  };

  static Shape shape(const std::array<Vector<2>, 4>& corners);
  static bool deform(const Shape&, const double* u, Kinematics&);
  static void strains(Kinematics&, const State*, PrincipalStrains*);
  static void forces(const Shape&, const Kinematics&, const material::PointUpdate*, double* force);
  static void tangent(const Shape&, const Kinematics&, const material::PointUpdate*, double two_G_added,
                      double* K);
  static State updated(const Kinematics&, int point, const material::PointUpdate&);
  static Stress cauchy(const Kinematics&, int point, const material::PointUpdate&);
  static Gradient gradient(const Kinematics& k, int point) {
    return {k.rr[point], k.rz[point], k.zr[point], k.zz[point]};
  }
  static Stress turned(const Stress&, const Gradient& from, const Gradient& to);
  static State continued(const State&, const State&, double factor);
  static double contraction(const Stress&, const Stress&);
  static PrincipalStrains plastic_strain(const State&);
};

} // namespace platen::fe
