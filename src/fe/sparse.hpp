#pragma once
// A sparse linear system with a fixed pattern, solved by MUMPS.

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace platen::fe {

/// Rows and columns of the entries of a square matrix that is assembled from dense element matrices;
/// row-wise, sorted, each entry once.
struct Pattern {
  int n = 0;
  std::vector<int> row_start; ///< n + 1
  std::vector<int> column;

  /// Position of entry (i, j), which must exist.
  int find(int i, int j) const;
};

/// Pattern of element matrices over the unknowns of each element.
Pattern pattern_of(int unknowns, std::span<const std::vector<int>> element_unknowns);

enum class Symmetry { unsymmetric, general_symmetric };
enum class Ordering {
  amf,
  pord,
  scotch
}; ///< measured: amf in 2-D, pord up to 30,000 unknowns in 3-D, then scotch

/// Direct solver. The analysis is done once; factorise and solve as often as wanted.
class DirectSolver {
 public:
  DirectSolver(const Pattern&, Symmetry, Ordering);
  ~DirectSolver();
  DirectSolver(DirectSolver&&) noexcept;

  /// Values in the order of the pattern. False where the matrix is singular.
  [[nodiscard]] bool factorise(std::span<const double> values);
  /// Replaces the right-hand side by the solution.
  void solve(std::span<double> rhs_to_solution);

 private:
  struct Mumps;
  std::unique_ptr<Mumps> mumps;
};

} // namespace platen::fe
