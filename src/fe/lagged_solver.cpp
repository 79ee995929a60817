#include "fe/lagged_solver.hpp"

#include "core/vector_clones.hpp"
#include "fe/plain.hpp"
#include "fe/stopwatch.hpp"

#include <algorithm>
#include <cmath>
#include <new>

namespace platen::fe {
namespace {

/// Most steps of GMRES; with the matrix's own factors two or three do.
constexpr int steps_max = 40;

/// Eight sums side by side: one waits for its last addition.
PLATEN_VECTOR_CLONES
double dot(std::span<const double> a, std::span<const double> b) {
  double sums[8] = {};
  std::size_t i = 0;
  for (; i + 8 <= a.size(); i += 8)
    for (int k = 0; k < 8; ++k) sums[k] += a[i + k] * b[i + k];
  double sum = 0;
  for (; i < a.size(); ++i) sum += a[i] * b[i];
  for (const double part : sums) sum += part;
  return sum;
}

/// y += A x of one element, its matrix by columns.
template <std::size_t most>
inline void add(const double* A, std::size_t n, const int* unknowns, const double* x, double* y) {
  double part[most] = {};
  for (std::size_t j = 0; j < n; ++j, A += n)
    for (std::size_t i = 0; i < n; ++i) part[i] += A[i] * x[unknowns[j]];
  for (std::size_t i = 0; i < n; ++i) y[unknowns[i]] += part[i];
}
PLATEN_VECTOR_CLONES [[gnu::flatten]] void add_product(const double* A, const std::vector<int>& unknowns,
                                                       const double* x, double* y) {
  if (unknowns.size() == 8) add<8>(A, 8, unknowns.data(), x, y); // most of a section: unrolled
  else add<24>(A, unknowns.size(), unknowns.data(), x, y);
}

} // namespace

LaggedSolver::LaggedSolver(int unknowns, std::vector<std::vector<int>> element_unknowns,
                           std::span<const Vector3> middles)
    : elements(std::move(element_unknowns)), direct(unknowns, elements, middles),
      factorisation_cost(direct.factorisation_cost()) {}

Outcome LaggedSolver::matrix(std::span<const double> element_matrices) {
  matrices = element_matrices;
  fresh = false;
  return wanted ? factorise() : Outcome::done;
}

Outcome LaggedSolver::factorise() {
  Stopwatch watch(factorisation_s);
  wanted = true; // unless it succeeds: what is there of the factors is of no matrix
  if (!direct.factorise(matrices)) return Outcome::singular;
  fresh = true;
  wanted = false;
  spent = factorisation_cost;
  solved = 0;
  return Outcome::done;
}

Outcome LaggedSolver::solve(std::span<double> x, double tolerance) {
  int steps = 0;
  Outcome outcome = gmres(x, tolerance, steps);
  if (outcome != Outcome::done && !fresh) {
    outcome = factorise();
    if (outcome == Outcome::done) outcome = gmres(x, tolerance, steps);
  }
  if (outcome != Outcome::done) return outcome;
  // Factorise next time if this solution cost more than all since the last factorisation, with it, on
  // average.
  spent += steps;
  ++solved;
  wanted = plain || steps * solved > spent;
  return Outcome::done;
}

void LaggedSolver::multiply(std::span<const double> x, std::span<double> y) const {
  std::fill(y.begin(), y.end(), 0.0);
  const double* a = matrices.data();
  for (const auto& element : elements) {
    add_product(a, element, x.data(), y.data());
    a += element.size() * element.size();
  }
}

/// GMRES preconditioned from the right. Where it is not done, x is untouched.
Outcome LaggedSolver::gmres(std::span<double> x, double tolerance, int& steps) {
  const double size = std::sqrt(dot(x, x));
  steps = 1;
  if (!std::isfinite(size)) return Outcome::singular;
  if (!(size > 0)) return Outcome::done;
  std::vector<std::vector<double>> basis{{x.begin(), x.end()}}, preconditioned;
  for (double& v : basis[0]) v /= size;
  std::vector<std::vector<double>> hessenberg; // columns, rotated to upper triangular
  std::vector<double> cosine, sine, rest{size}, product(x.size());
  for (int k = 0; k < steps_max; ++k) {
    preconditioned.push_back(basis[k]);
    direct.solve(preconditioned[k]);
    multiply(preconditioned[k], product);
    std::vector<double> h(k + 2);
    for (int i = 0; i <= k; ++i) {
      h[i] = dot(basis[i], product);
      for (std::size_t n = 0; n < product.size(); ++n) product[n] -= h[i] * basis[i][n];
    }
    h[k + 1] = std::sqrt(dot(product, product));
    if (!std::isfinite(h[k + 1])) return Outcome::singular;
    for (int i = 0; i < k; ++i) {
      const double a = h[i], b = h[i + 1];
      h[i] = cosine[i] * a + sine[i] * b;
      h[i + 1] = cosine[i] * b - sine[i] * a;
    }
    const double below = h[k + 1], length = std::hypot(h[k], below);
    if (!(length > 0)) return Outcome::singular;
    cosine.push_back(h[k] / length);
    sine.push_back(below / length);
    h[k] = length;
    hessenberg.push_back(h);
    rest.push_back(-sine[k] * rest[k]);
    rest[k] *= cosine[k];
    if (std::abs(rest[k + 1]) <= tolerance * size || below <= 1e-14 * length) {
      std::fill(x.begin(), x.end(), 0.0);
      for (int i = k; i >= 0; --i) {
        for (int j = i + 1; j <= k; ++j) rest[i] -= hessenberg[j][i] * rest[j];
        rest[i] /= hessenberg[i][i];
        for (std::size_t n = 0; n < x.size(); ++n) x[n] += rest[i] * preconditioned[i][n];
      }
      steps = k + 1;
      return Outcome::done;
    }
    for (double& v : product) v /= below;
    basis.push_back(product);
  }
  return Outcome::steps;
}

} // namespace platen::fe
