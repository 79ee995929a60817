#pragma once
// Equilibrium of a part of a sphere between mirrors under rigid frictionless planes.

#include "fe/constraints.hpp"
#include "fe/contact.hpp"
#include "fe/lagged_solver.hpp"
#include "fe/newton.hpp"
#include "fe/solid.hpp"

#include <vector>

namespace platen::fe {

/// Where the planes are, and what the contact and the material remember: all that an equilibrium depends on.
template <Element E> struct Conditions {
  std::span<const double> heights; ///< of the planes along their normals (R0)
  ContactMemory memory;
  std::span<const typename E::State> start; ///< of the Gauss points
};

/// Solid, mirrors, contact and solver. Its members but the solver's are values or say only what they are
/// asked; `response` holds the last evaluation.
template <Element E> class Equilibrium {
 public:
  using Mesh = typename E::Mesh;

  /// Planes along unit normals; `copies`: how many copies of the mesh press on each.
  Equilibrium(Mesh, material::Model, std::vector<Vector<Mesh::dim>> normals, std::vector<int> copies,
              const ContactRule&, NewtonSettings);
  Equilibrium(const Equilibrium&) = delete;
  Equilibrium& operator=(const Equilibrium&) = delete;

  const Solid<E> solid;
  const Constraints<Mesh> constraints;
  const Contact<Mesh> contact;
  NewtonSettings settings;

  /// Solves for the free displacements, starting from the guess in x.
  StepReport solve(const Conditions<E>&, std::vector<double>& x);
  /// Displacement components of the last evaluation.
  const std::vector<double>& displacement() const { return u; }
  const Response<E>& response() const { return answer; }
  /// The next solution depends on nothing that was solved before.
  void forget() { solver.forget(); }

  // As newton() asks a system:
  Cause evaluate(const std::vector<double>& x, Iterate&);
  Cause linearise(const Iterate&);
  Cause solve(std::span<double> rhs_to_solution);

 private:
  LaggedSolver solver;
  const Conditions<E>* conditions = nullptr; ///< of the solution in progress
  Response<E> answer;
  std::vector<double> u, matrices, reduced;
  double relative = 1; ///< residual of the last linearisation
};

} // namespace platen::fe
