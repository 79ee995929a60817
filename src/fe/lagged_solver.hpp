#pragma once
// Newton's linear systems in space, where a factorisation costs fifty solutions with it.
//
// The tangents of neighbouring iterates differ little: a few faces touch or part, some points begin to flow.
// So the factors of an earlier tangent precondition GMRES for the present one, until a new factorisation
// pays. For that they need no more than single precision.

#include "fe/sparse.hpp"

#include <span>
#include <vector>

namespace platen::fe {

class LaggedSolver {
 public:
  /// As DirectSolver's; unsymmetric, as plastic tangents are.
  LaggedSolver(int unknowns, std::vector<std::vector<int>> element_unknowns);

  /// The matrix of the next solutions; factorised where that pays. The span must stay. False where it was to
  /// be factorised and is singular.
  [[nodiscard]] bool matrix(std::span<const double> element_matrices);
  /// Replaces the right-hand side by the solution, up to a residual of `tolerance` of it.
  [[nodiscard]] bool solve(std::span<double> rhs_to_solution);

  double factorisation_s = 0; ///< spent so far

  static constexpr double tolerance = 1e-2;

 private:
  bool factorise();
  void multiply(std::span<const double> x, std::span<double> y) const;
  int gmres(std::span<double> rhs_to_solution);

  std::vector<std::vector<int>> elements;
  DirectSolverOf<float> direct;
  std::span<const double> matrices;
  bool fresh = false; ///< the factors are those of the matrix
  bool wanted = true; ///< to factorise the next matrix
  double spent = 0;   ///< since the last factorisation, in solutions with its factors
  int solved = 0;
};

} // namespace platen::fe
