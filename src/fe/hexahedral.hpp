#pragma once
// A solid in space in finite strain: eight-node hexahedra whose dilatation is its mean over the element, so
// that isochoric plastic flow does not lock them. The formulation is that of fe/axisymmetric.hpp.

#include "fe/axisymmetric.hpp"
#include "fe/vector3.hpp"

#include <array>
#include <span>
#include <vector>

namespace platen::fe {

/// What a Gauss point in space remembers.
struct SpatialPointState {
  Symmetric3 Cp_inv{1, 1, 1, 0, 0, 0};
  double phi = 0;
};

class HexahedralSolid {
 public:
  using State = SpatialPointState;

  HexahedralSolid(std::vector<Vector3> nodes, std::vector<std::array<int, 8>> hexes, material::Model);

  int points() const { return 8 * static_cast<int>(hexes.size()); }

  /// Internal forces (unit R0^2 Pa) at displacements u (x, y, z of each node, in units of R0), from the state
  /// `committed`. Where it fails the rest is unspecified.
  [[nodiscard]] Evaluation evaluate(std::span<const double> u);
  /// The tangent at the last evaluation.
  void linearise();

  const std::vector<Vector3> nodes;
  const std::vector<std::array<int, 8>> hexes;
  const material::Model model;
  std::vector<State> committed;

  std::vector<double> force;                  ///< internal force per component of u
  std::vector<double> tangent;                ///< element matrices, 24x24, by columns
  std::vector<material::PointUpdate> updates; ///< per Gauss point, eight an element
  std::vector<double> volume;                 ///< reference volume per Gauss point (R0^3)
  material::UpdateCounts counts;              ///< accumulated
  PhaseTimes times;

  /// Cauchy stress of a Gauss point after an evaluation.
  Symmetric3 cauchy(int point) const;
  /// State of a Gauss point after an evaluation, not yet committed.
  State updated(int point) const;

 private:
  using Gradients = std::array<Vector3, 8>; ///< of the shape functions
  struct Kinematics {                       ///< of a Gauss point at the current iterate
    Gradients grad;                         ///< spatial
    std::array<Vector3, 3> F;               ///< F_bar, rows
    double J;                               ///< det F, not averaged
    Spectral b;                             ///< b_e^tr
  };

  bool deform(std::span<const double> u);
  void assemble_forces();
  void assemble_tangent(int element);

  std::vector<Gradients> shapes; ///< in the reference configuration
  std::vector<Kinematics> kinematics;
  std::vector<double> element_J;      ///< J_bar
  std::vector<double> element_volume; ///< reference volume
  std::vector<std::array<double, 3>> eps_trial;
  std::vector<double> phi_n;
};

} // namespace platen::fe
