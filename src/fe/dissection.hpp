#pragma once
// A sparse linear system that is a sum of dense element matrices, solved directly by nested dissection.
//
// The elements are cut into halves along the planes that share the fewest unknowns, these again, and so on.
// From the smallest parts up, what lies inside a part is eliminated in one small dense matrix, and what is
// left of it acts on the part's boundary alone (A. George, SIAM J. Numer. Anal. 10, 345, 1973). Where
// elements lie is known here, so the cuts are better than those of a general ordering, and single precision
// does, since the factors are refined by whoever uses them (fe/lagged_solver.hpp).

#include "fe/tensor.hpp"

#include <memory>
#include <span>
#include <vector>

namespace platen::fe {

/// LU factors in single precision, rows exchanged inside a front. The cuts are made once; factorise and solve
/// as often as wanted.
class Dissection {
 public:
  /// The unknowns of each element, numbered from 0, and where its middle is.
  Dissection(int unknowns, std::vector<std::vector<int>> element_unknowns, std::span<const Vector3> middles);
  ~Dissection();
  Dissection(Dissection&&) noexcept;

  /// The element matrices one after the other, by columns. False where their sum is singular.
  [[nodiscard]] bool factorise(std::span<const double> element_matrices);
  /// Replaces the right-hand side by the solution, to single precision.
  void solve(std::span<double> rhs_to_solution) const;

  /// What a factorisation costs, in solutions. Counted rather than timed, so that a press gives the same
  /// curve on any machine.
  double factorisation_cost() const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree;
};

} // namespace platen::fe
