#pragma once
// Linear systems of a block of elements, for tests of solvers.

#include "fe/tensor.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace platen::test {

struct Elements {
  int unknowns = 0;
  std::vector<std::vector<int>> lists; ///< unknowns of each element
  std::vector<fe::Vector3> middles;
};

/// nx by ny by nz bricks (nz = 0: squares) with some unknowns a node.
inline Elements block(int nx, int ny, int nz, int per_node) {
  Elements e;
  e.unknowns = per_node * (nx + 1) * (ny + 1) * (nz + 1);
  for (int k = 0; k < std::max(nz, 1); ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        auto& list = e.lists.emplace_back();
        for (int corner = 0; corner < (nz > 0 ? 8 : 4); ++corner) {
          const int node = i + corner % 2 + (nx + 1) * (j + corner / 2 % 2 + (ny + 1) * (k + corner / 4));
          for (int u = 0; u < per_node; ++u) list.push_back(per_node * node + u);
        }
        e.middles.push_back({i + 0.5, j + 0.5, nz > 0 ? k + 0.5 : 0});
      }
  return e;
}

inline std::vector<double> random_vector(std::size_t n, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> random(-1, 1);
  std::vector<double> x(n);
  for (double& v : x) v = random(generator);
  return x;
}

/// One random matrix an element, by columns, plus `diagonal`: B B^T, or entries in (-1, 1).
inline std::vector<double> matrices(const Elements& e, bool positive, double diagonal, unsigned seed) {
  std::vector<double> all;
  for (const auto& list : e.lists) {
    const std::size_t n = list.size();
    const std::vector<double> B = random_vector(n * n, seed++);
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i) {
        double entry = positive ? 0 : B[n * j + i];
        for (std::size_t k = 0; positive && k < n; ++k) entry += B[n * k + i] * B[n * k + j];
        all.push_back(entry + (i == j ? diagonal : 0));
      }
  }
  return all;
}

/// Their sum, by rows.
inline std::vector<double> dense(const Elements& e, const std::vector<double>& elements) {
  std::vector<double> A(static_cast<std::size_t>(e.unknowns) * e.unknowns);
  const double* a = elements.data();
  for (const auto& list : e.lists)
    for (const int column : list)
      for (const int row : list) A[static_cast<std::size_t>(row) * e.unknowns + column] += *a++;
  return A;
}

inline std::vector<double> times(const std::vector<double>& A, const std::vector<double>& x) {
  std::vector<double> y(x.size());
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < x.size(); ++j) y[i] += A[i * x.size() + j] * x[j];
  return y;
}

/// Gauss' elimination with the largest pivots of the columns.
inline std::vector<double> solve_dense(std::vector<double> A, std::vector<double> b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t p = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (std::abs(A[i * n + k]) > std::abs(A[p * n + k])) p = i;
    for (std::size_t j = 0; j < n; ++j) std::swap(A[p * n + j], A[k * n + j]);
    std::swap(b[p], b[k]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const double share = A[i * n + k] / A[k * n + k];
      for (std::size_t j = k; share != 0 && j < n; ++j) A[i * n + j] -= share * A[k * n + j];
      b[i] -= share * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) b[k] -= A[k * n + j] * b[j];
    b[k] /= A[k * n + k];
  }
  return b;
}

inline double length(const std::vector<double>& x) {
  double sum = 0;
  for (const double v : x) sum += v * v;
  return std::sqrt(sum);
}

inline std::vector<double> difference(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
  return a;
}

} // namespace platen::test
