#include "fe/sparse.hpp"

#include <dmumps_c.h>

#include <algorithm>
#include <stdexcept>
#include <string>

// The presses run side by side, one thread each.
extern "C" void openblas_set_num_threads(int) __attribute__((weak));

namespace platen::fe {

int Pattern::find(int i, int j) const {
  const auto begin = column.begin() + row_start[i], end = column.begin() + row_start[i + 1];
  return static_cast<int>(std::lower_bound(begin, end, j) - column.begin());
}

Pattern pattern_of(int unknowns, std::span<const std::vector<int>> element_unknowns) {
  std::vector<std::vector<int>> rows(unknowns);
  for (const auto& element : element_unknowns)
    for (const int i : element) rows[i].insert(rows[i].end(), element.begin(), element.end());
  Pattern pattern{unknowns, {0}, {}};
  for (auto& row : rows) {
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    pattern.column.insert(pattern.column.end(), row.begin(), row.end());
    pattern.row_start.push_back(static_cast<int>(pattern.column.size()));
  }
  return pattern;
}

struct DirectSolver::Mumps {
  DMUMPS_STRUC_C id{};
  std::vector<int> irn, jcn;
  std::vector<double> a;
  std::vector<int> taken; ///< positions in the pattern that MUMPS sees: all, or the lower triangle
};

namespace {
void run(DMUMPS_STRUC_C& id, int job) {
  id.job = job;
  dmumps_c(&id);
}
} // namespace

DirectSolver::DirectSolver(const Pattern& pattern, Symmetry symmetry, Ordering ordering)
    : mumps(std::make_unique<Mumps>()) {
  if (openblas_set_num_threads) openblas_set_num_threads(1);
  Mumps& m = *mumps;
  const bool symmetric = symmetry == Symmetry::general_symmetric;
  for (int i = 0; i < pattern.n; ++i)
    for (int k = pattern.row_start[i]; k < pattern.row_start[i + 1]; ++k)
      if (const int j = pattern.column[k]; !symmetric || j <= i) {
        m.irn.push_back(i + 1);
        m.jcn.push_back(j + 1);
        m.taken.push_back(k);
      }
  m.a.resize(m.irn.size());
  m.id.par = 1;
  m.id.sym = symmetric ? 2 : 0;
  m.id.comm_fortran = -987654; // MUMPS's USE_COMM_WORLD
  run(m.id, -1);
  for (int k = 0; k < 4; ++k) m.id.icntl[k] = k == 3 ? 0 : -1; // silent
  m.id.icntl[5] = m.id.icntl[7] = 0;                           // no permutation, no scaling
  m.id.icntl[6] = ordering == Ordering::amf ? 2 : ordering == Ordering::pord ? 4 : 3;
  m.id.icntl[9] = 0;   // no iterative refinement
  m.id.icntl[13] = 40; // % of workspace to spare for pivoting
  m.id.n = pattern.n;
  m.id.nnz = static_cast<MUMPS_INT8>(m.irn.size());
  m.id.irn = m.irn.data();
  m.id.jcn = m.jcn.data();
  m.id.a = m.a.data();
  run(m.id, 1);
  if (m.id.infog[0] < 0) throw std::runtime_error("MUMPS analysis failed: " + std::to_string(m.id.infog[0]));
}

DirectSolver::~DirectSolver() {
  if (mumps) run(mumps->id, -2);
}
DirectSolver::DirectSolver(DirectSolver&&) noexcept = default;

bool DirectSolver::factorise(std::span<const double> values) {
  Mumps& m = *mumps;
  for (std::size_t k = 0; k < m.taken.size(); ++k) m.a[k] = values[m.taken[k]];
  for (int attempt = 0; attempt < 4; ++attempt) {
    run(m.id, 2);
    if (m.id.infog[0] >= 0) return true;
    if (m.id.infog[0] != -8 && m.id.infog[0] != -9) return false; // not a matter of workspace: singular
    m.id.icntl[13] *= 2;
  }
  return false;
}

void DirectSolver::solve(std::span<double> x) {
  mumps->id.rhs = x.data();
  run(mumps->id, 3);
}

} // namespace platen::fe
