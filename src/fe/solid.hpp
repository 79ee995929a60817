#pragma once
// A solid of one kind of element: internal forces and tangent at given displacements.

#include "fe/element.hpp"
#include "fe/stopwatch.hpp"

#include <span>
#include <vector>

namespace platen::fe {

/// Seconds per phase.
struct PhaseTimes {
  double material_s = 0, assembly_s = 0, factorisation_s = 0, solve_s = 0;
};

enum class Evaluation { done, inverted_element, refused_material };

/// What a solid answers to displacements.
template <Element E> struct Response {
  std::vector<typename E::Kinematics> kinematics; ///< per element
  std::vector<material::PointUpdate> updates;     ///< per Gauss point
  std::vector<double> force;                      ///< internal, per component of u (R0^2 Pa)
  material::UpdateCounts counts;                  ///< accumulated
  PhaseTimes times;                               ///< accumulated

  /// State and Cauchy stress of a Gauss point.
  typename E::State state(int point) const {
    return E::updated(kinematics[point / E::points], point % E::points, updates[point]);
  }
  typename E::Stress cauchy(int point) const {
    return E::cauchy(kinematics[point / E::points], point % E::points, updates[point]);
  }

  std::vector<PrincipalStrains> trial;
  std::vector<double> phi;
};

template <Element E> class Solid {
 public:
  using State = typename E::State;
  static constexpr int dim = E::Mesh::dim;

  Solid(typename E::Mesh, material::Model);

  const typename E::Mesh mesh;
  const material::Model model;

  int elements() const { return static_cast<int>(mesh.elements.size()); }
  int points() const { return E::points * elements(); }
  int components() const { return dim * static_cast<int>(mesh.nodes.size()); } ///< of a displacement field
  double volume(int point) const { return shapes[point / E::points].volume[point % E::points]; } ///< R0^3
  /// Where a Gauss point lies in the undeformed sphere.
  Vector<dim> place(int point) const;

  /// The response to displacements u (components of each node, in R0), from the states `start`. Where it
  /// fails the rest is unspecified.
  [[nodiscard]] Evaluation evaluate(std::span<const double> u, std::span<const State> start,
                                    Response<E>&) const;
  /// The tangent there: element matrices by columns. Where material flows it is stiffer by `added` of the
  /// initial elastic shear stiffness, which makes Newton's corrections smaller, not its solution another.
  void linearise(Response<E>&, double added, std::span<double> matrices) const;

 private:
  std::vector<typename E::Shape> shapes;
};

} // namespace platen::fe
