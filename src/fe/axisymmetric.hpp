#pragma once
// A solid of revolution in finite strain: four-node quadrilaterals whose dilatation is its mean over the
// element, so that isochoric plastic flow does not lock them.
//
// With J_bar = v/V (current over reference volume of the element) and F_bar = (J_bar/det F)^{1/3} F, the
// internal energy is the integral of psi(F_bar), and the internal forces are its exact derivatives: the
// element balances energy by itself. Gauss points keep C_p^{-1}, so that b_e^tr = F_bar C_p^{-1} F_bar^T.

#include "fe/quarter_disc.hpp"
#include "fe/vector3.hpp"
#include "material/update.hpp"

#include <array>
#include <span>
#include <vector>

namespace platen::fe {

/// What a Gauss point remembers.
struct PointState {
  std::array<double, 4> Cp_inv{1, 1, 0, 1}; ///< rr, zz, rz, tt in the reference section
  double phi = 0;
};

/// Seconds per phase.
struct PhaseTimes {
  double material_s = 0, assembly_s = 0, factorisation_s = 0, solve_s = 0;
};

enum class Evaluation { done, inverted_element, refused_material };

class AxisymmetricSolid {
 public:
  using State = PointState;

  AxisymmetricSolid(AxisymmetricMesh, material::Model);

  int unknowns() const { return 2 * static_cast<int>(mesh.nodes.size()); }
  /// Unknowns of an element, in the order of its matrix: r and z of its four nodes.
  std::array<int, 8> unknowns_of(int element) const;
  int points() const { return 4 * static_cast<int>(mesh.quads.size()); }

  /// Internal forces (2 pi included, unit R0^2 Pa) at displacements u (r and z of each node, in units of R0),
  /// from the state `committed`. Where it fails the rest is unspecified.
  [[nodiscard]] Evaluation evaluate(std::span<const double> u);
  /// The tangent at the last evaluation; where material flows, stiffer by `added` of the initial elastic
  /// shear stiffness, which makes Newton's corrections smaller, not its solution another.
  void linearise(double added = 0);

  /// Makes the state of the last evaluation the committed one.
  void commit();

  const AxisymmetricMesh mesh;
  const material::Model model;
  std::vector<PointState> committed;

  std::vector<double> force;                  ///< internal force per unknown
  std::vector<double> tangent;                ///< element matrices, 8x8, by columns (DirectSolver)
  std::vector<material::PointUpdate> updates; ///< per Gauss point, four an element
  std::vector<double> volume;                 ///< reference volume per Gauss point, 2 pi included (R0^3)
  material::UpdateCounts counts;              ///< accumulated
  PhaseTimes times;

  /// Cauchy stress of a Gauss point after an evaluation: rr, zz, rz, tt.
  std::array<double, 4> cauchy(int point) const;
  /// State of a Gauss point after an evaluation, not yet committed.
  PointState updated(int point) const;

 private:
  struct Shape { ///< of a Gauss point in the reference section
    std::array<double, 4> N_R, N_Z, N_over_R;
  };
  struct Kinematics {                         ///< of a Gauss point at the current iterate
    std::array<double, 4> N_r, N_z, N_over_r; ///< spatial gradients
    std::array<double, 5> F;                  ///< F_bar: rr, rz, zr, zz, tt
    double J;                                 ///< det F, not averaged
    PlaneSpectral b;                          ///< b_e^tr in the section
  };

  bool deform(std::span<const double> u);
  void assemble_forces();
  void assemble_tangent(int element, double two_G_added);

  std::vector<Shape> shapes;
  std::vector<Kinematics> kinematics;
  std::vector<double> element_J;      ///< J_bar
  std::vector<double> element_volume; ///< reference volume
  std::vector<std::array<double, 3>> eps_trial;
  std::vector<double> phi_n;
};

} // namespace platen::fe
