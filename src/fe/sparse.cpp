#include "fe/sparse.hpp"

#include <dmumps_c.h>
#include <smumps_c.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <type_traits>

extern "C" void openblas_set_num_threads(int); // in no header of Debian's run-time package

namespace platen::fe {

namespace {
template <class Number> struct Library;
template <> struct Library<double> {
  using Struct = DMUMPS_STRUC_C;
  static constexpr auto call = dmumps_c;
};
template <> struct Library<float> {
  using Struct = SMUMPS_STRUC_C;
  static constexpr auto call = smumps_c;
};
} // namespace

template <class Number> struct DirectSolverOf<Number>::Mumps {
  typename Library<Number>::Struct id{};
  std::vector<int> start{1}, variable; ///< of the elements, numbered from 1
  std::vector<Number> a, x;

  void run(int job) {
    id.job = job;
    Library<Number>::call(&id);
  }
};

namespace {

/// MUMPS's own choice (AMF) is good for plane meshes. Of hexahedra PORD fills less, until it gets erratic.
int ordering(int unknowns, std::size_t largest_element) {
  constexpr int automatic = 7, pord = 4, scotch = 3;
  if (largest_element <= 8) return automatic;
  return unknowns < 30000 ? pord : scotch;
}
} // namespace

template <class Number>
DirectSolverOf<Number>::DirectSolverOf(int unknowns, std::span<const std::vector<int>> element_unknowns,
                                       Symmetry symmetry)
    : mumps(std::make_unique<Mumps>()) {
  openblas_set_num_threads(1); // presses run side by side, one thread each
  Mumps& m = *mumps;
  std::size_t entries = 0, largest = 0;
  for (const auto& element : element_unknowns) {
    for (const int i : element) m.variable.push_back(i + 1);
    m.start.push_back(static_cast<int>(m.variable.size()) + 1);
    const std::size_t n = element.size();
    largest = std::max(largest, n);
    entries += symmetry == Symmetry::unsymmetric ? n * n : n * (n + 1) / 2;
  }
  m.a.resize(entries);
  m.id.par = 1;
  m.id.sym = symmetry == Symmetry::unsymmetric ? 0 : 2;
  m.id.comm_fortran = -987654; // MUMPS's USE_COMM_WORLD
  m.run(-1);
  for (int k = 0; k < 4; ++k) m.id.icntl[k] = k == 3 ? 0 : -1; // silent
  m.id.icntl[4] = 1;                                           // element matrices
  m.id.icntl[5] = m.id.icntl[7] = 0;                           // no permutation, no scaling
  m.id.icntl[6] = ordering(unknowns, largest);
  m.id.icntl[9] = 0;   // no iterative refinement
  m.id.icntl[13] = 40; // % of workspace to spare for pivoting
  m.id.n = unknowns;
  m.id.nelt = static_cast<MUMPS_INT>(element_unknowns.size());
  m.id.eltptr = m.start.data();
  m.id.eltvar = m.variable.data();
  m.id.a_elt = m.a.data();
  m.run(1);
  if (m.id.infog[0] < 0) throw std::runtime_error("MUMPS analysis failed: " + std::to_string(m.id.infog[0]));
}

template <class Number> DirectSolverOf<Number>::~DirectSolverOf() {
  if (mumps) mumps->run(-2);
}
template <class Number> DirectSolverOf<Number>::DirectSolverOf(DirectSolverOf&&) noexcept = default;

template <class Number> bool DirectSolverOf<Number>::factorise(std::span<const double> element_matrices) {
  Mumps& m = *mumps;
  const auto number = [](double value) { return static_cast<Number>(value); };
  if (m.id.sym == 0) std::transform(element_matrices.begin(), element_matrices.end(), m.a.begin(), number);
  else { // MUMPS takes the lower triangles
    auto from = element_matrices.begin();
    auto to = m.a.begin();
    for (int e = 0; e < m.id.nelt; ++e)
      for (int n = m.start[e + 1] - m.start[e], j = 0; j < n; ++j, from += n)
        to = std::transform(from + j, from + n, to, number);
  }
  for (int attempt = 0; attempt < 4; ++attempt) {
    m.run(2);
    if (m.id.infog[0] >= 0) return true;
    if (m.id.infog[0] != -8 && m.id.infog[0] != -9) return false; // not a matter of workspace: singular
    m.id.icntl[13] *= 2;
  }
  return false;
}

template <class Number> void DirectSolverOf<Number>::solve(std::span<double> x) {
  if constexpr (std::is_same_v<Number, double>) {
    mumps->id.rhs = x.data();
    mumps->run(3);
  } else {
    // What is small against the largest entry would be lost in single precision, what is too small for it at
    // all: scaled to 1.
    double largest = 0;
    for (const double value : x) largest = std::max(largest, std::abs(value));
    if (!(largest > 0)) return;
    mumps->x.resize(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) mumps->x[i] = static_cast<Number>(x[i] / largest);
    mumps->id.rhs = mumps->x.data();
    mumps->run(3);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = largest * mumps->x[i];
  }
}

template class DirectSolverOf<double>;
template class DirectSolverOf<float>;

} // namespace platen::fe
