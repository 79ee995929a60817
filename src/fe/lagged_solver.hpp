#pragma once
// Newton's linear systems.
//
// The tangents of neighbouring iterates differ little: a few faces touch or part, some points begin to flow.
// So the factors of an earlier tangent precondition GMRES (Saad & Schultz 1986) for the present one, until a
// new factorisation pays. For that they need no more than single precision.

#include "fe/dissection.hpp"

#include <span>
#include <vector>

namespace platen::fe {

enum class [[nodiscard]] Outcome{done, singular, steps};

class LaggedSolver {
 public:
  /// As Dissection's.
  LaggedSolver(int unknowns, std::vector<std::vector<int>> element_unknowns,
               std::span<const Vector3> middles);

  /// The matrix of the next solutions, by columns; factorised where that pays. The span must stay.
  Outcome matrix(std::span<const double> element_matrices);
  /// Replaces the right-hand side by the solution, up to a residual of `tolerance` of it. `steps`: the
  /// iteration stands still although the factors are the matrix's own.
  Outcome solve(std::span<double> rhs_to_solution, double tolerance);
  /// Factorises the next matrix: what is solved from here on does not depend on what was solved before.
  void forget() { wanted = true; }

  double factorisation_s = 0; ///< spent so far

 private:
  Outcome factorise();
  void multiply(std::span<const double> x, std::span<double> y) const;
  Outcome gmres(std::span<double> rhs_to_solution, double tolerance, int& steps);

  std::vector<std::vector<int>> elements;
  Dissection direct;
  double factorisation_cost; ///< in solutions with its factors
  std::span<const double> matrices;
  bool fresh = false; ///< the factors are those of the matrix
  bool wanted = true; ///< to factorise the next matrix
  double spent = 0;   ///< since the last factorisation, in solutions with its factors
  int solved = 0;
};

} // namespace platen::fe
