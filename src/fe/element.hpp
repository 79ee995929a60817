#pragma once
// What the solid asks of an element.
//
// Finite strain; the dilatation is its mean over the element, so that isochoric plastic flow does not lock
// it. With J_bar = v/V (current over reference volume of the element) and F_bar = (J_bar/det F)^{1/3} F, the
// internal energy is the integral of psi(F_bar), and the internal forces are its exact derivatives: the
// element balances energy by itself. Gauss points keep C_p^{-1}, so that b_e^tr = F_bar C_p^{-1} F_bar^T.

#include "fe/mesh.hpp"
#include "material/update.hpp"

#include <array>
#include <concepts>

namespace platen::fe {

using PrincipalStrains = std::array<double, 3>;

/// All functions are of one element; lengths in R0, stresses in Pa.
template <class E>
concept Element = requires(const typename E::Shape& shape, typename E::Kinematics& moved,
                           const typename E::State& state, const material::PointUpdate* updates,
                           const double* u, double* out, PrincipalStrains* trial, int point) {
  typename E::Mesh;     // dim, corners
  typename E::Stress;   // components of a tensor
  typename E::Gradient; // F_bar
  { E::points } -> std::convertible_to<int>;
  { E::unknowns } -> std::convertible_to<int>;
  /// Gradients and reference volumes (R0^3) of the Gauss points.
  { E::shape({}) } -> std::same_as<typename E::Shape>;
  { shape.volume[point] } -> std::convertible_to<double>;
  /// Deformation gradients; false where the element is inside out.
  { E::deform(shape, u, moved) } -> std::same_as<bool>;
  /// Writes the principal trial strains of its points from their states; the axes are kept.
  {E::strains(moved, &state, trial)};
  /// Writes the internal forces on the unknowns of the element.
  {E::forces(shape, moved, updates, out)};
  /// By columns; where material flows, 2 G stiffer in shear by the last number (Pa).
  {E::tangent(shape, moved, updates, 0.0, out)};
  { E::updated(moved, point, *updates) } -> std::same_as<typename E::State>;
  { E::cauchy(moved, point, *updates) } -> std::same_as<typename E::Stress>;
  { E::gradient(moved, point) } -> std::same_as<typename E::Gradient>;
  /// A stress as the material turns it from one deformation to another.
  {
    E::turned(typename E::Stress{}, typename E::Gradient{}, typename E::Gradient{})
    } -> std::same_as<typename E::Stress>;
  /// The state that flow at a constant rate from one to another reaches after a factor of that way.
  { E::continued(state, state, 0.0) } -> std::same_as<typename E::State>;
  /// Double contraction, and the largest principal plastic strains -ln(C_p^-1)/2 of a state.
  { E::contraction(typename E::Stress{}, typename E::Stress{}) } -> std::same_as<double>;
  { E::plastic_strain(state) } -> std::same_as<PrincipalStrains>;
};

} // namespace platen::fe
