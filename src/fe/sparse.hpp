#pragma once
// A sparse linear system that is a sum of dense element matrices, solved by MUMPS.
//
// The element matrices are handed over as they are: of an assembled matrix MUMPS sorts the entries at
// each factorisation, a tenth of its time.

#include <memory>
#include <span>
#include <vector>

namespace platen::fe {

enum class Symmetry { unsymmetric, general_symmetric };

/// Direct solver. The analysis is done once; factorise and solve as often as wanted. Number: of the factors,
/// double or float, which takes half the time and memory.
template <class Number> class DirectSolverOf {
 public:
  /// The unknowns of each element, numbered from 0. Throws std::runtime_error where MUMPS refuses them.
  DirectSolverOf(int unknowns, std::span<const std::vector<int>> element_unknowns, Symmetry);
  ~DirectSolverOf();
  DirectSolverOf(DirectSolverOf&&) noexcept;

  /// The element matrices one after the other, each whole and by columns. False where their sum is singular.
  [[nodiscard]] bool factorise(std::span<const double> element_matrices);
  /// Replaces the right-hand side by the solution.
  void solve(std::span<double> rhs_to_solution);

 private:
  struct Mumps;
  std::unique_ptr<Mumps> mumps;
};

using DirectSolver = DirectSolverOf<double>;

} // namespace platen::fe
