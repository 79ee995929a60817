#include "fe/dissection.hpp"

#include "core/vector_clones.hpp"
#include "fe/plain.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

// LAPACK and BLAS as OpenBLAS exports them; its headers are in no run-time package.
extern "C" {
void sgetrf_(const int* m, const int* n, float* a, const int* lda, int* pivots, int* info);
void slaswp_(const int* n, float* a, const int* lda, const int* k1, const int* k2, const int* pivots,
             const int* inc);
void strsm_(const char* side, const char* uplo, const char* trans, const char* diag, const int* m,
            const int* n, const float* alpha, const float* a, const int* lda, float* b, const int* ldb);
void sgemm_(const char* trans_a, const char* trans_b, const int* m, const int* n, const int* k,
            const float* alpha, const float* a, const int* lda, const float* b, const int* ldb,
            const float* beta, float* c, const int* ldc);
void openblas_set_num_threads(int);
}

namespace platen::fe {
namespace {

/// Parts of so few elements are not cut any more: below it the calls cost more than the arithmetic saves.
constexpr std::size_t smallest_part = 6;
/// Fronts up to this size are eliminated column by column here, larger ones by LAPACK.
constexpr int small_interior = 24, small_front = 96;
/// The larger part has at most this share of the elements.
constexpr double largest_share = 0.6;

/// Directions along which parts are cut: axes, edges and faces of a cube, and steeper ones in a plane.
constexpr std::array<Vector3, 13> directions{{{1, 0, 0},
                                              {0, 1, 0},
                                              {0, 0, 1},
                                              {1, 1, 0},
                                              {1, -1, 0},
                                              {0, 1, 1},
                                              {0, 1, -1},
                                              {1, 0, 1},
                                              {1, 0, -1},
                                              {2, 1, 0},
                                              {1, 2, 0},
                                              {2, -1, 0},
                                              {1, -2, 0}}};

/// A part of the mesh: its unknowns, those of its interior first.
struct Front {
  std::vector<int> elements;       ///< of a part that is not cut
  std::array<int, 2> half{-1, -1}; ///< fronts
  std::vector<int> unknowns;
  int interior = 0;
  std::vector<int> place;  ///< in `unknowns`: of the unknowns of the elements, or of the halves' boundaries
  std::size_t factors = 0; ///< where they begin
  std::vector<int> pivots; ///< as LAPACK counts them, from 1
  std::vector<int> rows, columns; ///< unknowns of L's and of U's blocks, `nobody` where these are filled up
  std::vector<Factor> boundary;   ///< what is left of the matrix there

  int size() const { return static_cast<int>(unknowns.size()); }
  int boundary_size() const { return size() - interior; }
};

/// Numbers side by side in a register. Columns of factors are filled up to whole ones with zeros: the many
/// short loops of a solution have no rests then.
constexpr int width = 8;
using Block = Factor __attribute__((vector_size(width * sizeof(Factor)), aligned(sizeof(Factor))));
constexpr int whole(int n) { return (n + width - 1) / width * width; }

/// The factors of a front, by columns, where they lie one behind the other: of its interior L without its
/// diagonal of ones, U without its own, whose inverse is `per_pivot`; L below it, U beside it.
template <class Number> struct FactorsOf {
  int inner, outer; ///< lengths of the columns
  Number *lower, *upper, *per_pivot, *below, *beside;

  FactorsOf(const Front& front, Number* begin)
      : inner(whole(front.interior)), outer(whole(front.boundary_size())), lower(begin),
        upper(lower + front.interior * inner), per_pivot(upper + front.interior * inner),
        below(per_pivot + inner), beside(below + front.interior * outer) {}
  static std::size_t entries(const Front& front) {
    const std::size_t inner = whole(front.interior), outer = whole(front.boundary_size());
    return front.interior * (2 * inner + outer) + inner + front.boundary_size() * inner;
  }
};

/// Eight at once: written one by one they could not be read as a block for a while.
inline Block gathered(const Factor* x, const int* u) {
  static_assert(width == 8);
  return Block{x[u[0]], x[u[1]], x[u[2]], x[u[3]], x[u[4]], x[u[5]], x[u[6]], x[u[7]]};
}

inline Block& block(Factor* at) { return *reinterpret_cast<Block*>(at); }
inline const Block& block(const Factor* at) { return *reinterpret_cast<const Block*>(at); }

/// y -= A x, the columns of A of whole blocks.
inline void subtract_product(const Factor* A, int rows, int columns, const Factor* x, Factor* y) {
  int j = 0;
  for (; j + 4 <= columns; j += 4, A += 4 * rows)
    for (int i = 0; i < rows; i += width)
      block(y + i) -= (x[j] * block(A + i) + x[j + 1] * block(A + rows + i)) +
                      (x[j + 2] * block(A + 2 * rows + i) + x[j + 3] * block(A + 3 * rows + i));
  for (; j < columns; ++j, A += rows)
    for (int i = 0; i < rows; i += width) block(y + i) -= x[j] * block(A + i);
}

/// LU of the first `interior` columns of a square matrix, and what it leaves of the rest.
PLATEN_VECTOR_CLONES
bool eliminate(Factor* a, int size, int interior, int* pivots) {
  for (int k = 0; k < interior; ++k) {
    Factor* column = a + k * size;
    int p = k;
    for (int i = k + 1; i < interior; ++i)
      if (std::abs(column[i]) > std::abs(column[p])) p = i;
    if (!(std::abs(column[p]) > 0)) return false;
    pivots[k] = p + 1;
    if (p != k)
      for (int j = 0; j < size; ++j) std::swap(a[j * size + k], a[j * size + p]);
    const Factor per_pivot = 1 / column[k];
    for (int i = k + 1; i < size; ++i) column[i] *= per_pivot;
    for (int j = k + 1; j < size; ++j) {
      Factor* other = a + j * size;
      const Factor share = other[k];
      for (int i = k + 1; i < size; ++i) other[i] -= share * column[i];
    }
  }
  return true;
}

PLATEN_VECTOR_CLONES [[gnu::flatten]] void forward(const std::vector<Front>& fronts, const Factor* factors,
                                                   Factor* x, Factor* y) {
  for (const Front& front : fronts) {
    const FactorsOf<const Factor> f(front, factors + front.factors);
    const int interior = front.interior, boundary = front.boundary_size();
    const int* const unknowns = front.unknowns.data();
    for (int i = 0; i < f.inner; i += width) block(y + i) = gathered(x, &front.rows[i]);
    for (int i = 0; i < f.outer; i += width) block(y + f.inner + i) = Block{};
    for (int j = 0; j < interior; ++j)
      for (int i = j / width * width; i < f.inner; i += width)
        block(y + i) -= y[j] * block(f.lower + j * f.inner + i);
    subtract_product(f.below, f.outer, interior, y, y + f.inner);
    for (int i = 0; i < interior; ++i) x[unknowns[i]] = y[i];
    for (int i = 0; i < boundary; ++i) x[unknowns[interior + i]] += y[f.inner + i];
  }
}

PLATEN_VECTOR_CLONES [[gnu::flatten]] void backward(const std::vector<Front>& fronts, const Factor* factors,
                                                    Factor* x, Factor* y) {
  for (auto front = fronts.rbegin(); front != fronts.rend(); ++front) {
    const FactorsOf<const Factor> f(*front, factors + front->factors);
    const int interior = front->interior, boundary = front->boundary_size();
    const int* const unknowns = front->unknowns.data();
    for (int i = 0; i < f.inner + f.outer; i += width) block(y + i) = gathered(x, &front->columns[i]);
    subtract_product(f.beside, f.inner, boundary, y + f.inner, y);
    for (int j = interior - 1; j >= 0; --j) {
      const Factor solved = y[j] * f.per_pivot[j];
      for (int i = 0; i < j; i += width) block(y + i) -= solved * block(f.upper + j * f.inner + i);
      x[unknowns[j]] = solved;
    }
  }
}

[[maybe_unused]] bool eliminate_by_blocks(float* a, int size, int interior, int* pivots) {
  const int boundary = size - interior, one = 1;
  const float plus = 1, minus = -1;
  int info = 0;
  sgetrf_(&interior, &interior, a, &size, pivots, &info);
  if (info != 0) return false;
  if (boundary == 0) return true;
  float *below = a + interior, *beside = a + static_cast<std::size_t>(interior) * size;
  slaswp_(&boundary, beside, &size, &one, &interior, pivots, &one);
  strsm_("L", "L", "N", "U", &interior, &boundary, &plus, a, &size, beside, &size);
  strsm_("R", "U", "N", "N", &boundary, &interior, &plus, a, &size, below, &size);
  sgemm_("N", "N", &boundary, &boundary, &interior, &minus, below, &size, beside, &size, &plus,
         beside + interior, &size);
  return true;
}

#ifdef PLATEN_PLAIN // without LAPACK
bool eliminate_by_blocks(double* a, int size, int interior, int* pivots) {
  return eliminate(a, size, interior, pivots);
}
#endif

} // namespace

struct Dissection::Tree {
  std::vector<std::vector<int>> elements; ///< unknowns
  std::vector<std::size_t> matrix;        ///< where each element's begins
  std::vector<Front> fronts;              ///< halves before what they are halves of
  std::vector<Factor> factors;            ///< of all fronts
  std::vector<Factor> work;
  mutable std::vector<Factor> x, y;

  std::vector<int> uses; ///< of each unknown: parts that have it and are not yet joined

  /// Takes what a front is made of; what nobody else has is its interior.
  int add(Front front, const std::vector<int>& parts) {
    std::vector<int> sorted = parts, boundary;
    std::sort(sorted.begin(), sorted.end());
    for (auto from = sorted.begin(); from != sorted.end();) {
      const int unknown = *from;
      const auto to = std::upper_bound(from, sorted.end(), unknown);
      const int here = static_cast<int>(to - from);
      (uses[unknown] == here ? front.unknowns : boundary).push_back(unknown);
      uses[unknown] -= here - 1; // the front stands for its parts from now on
      from = to;
    }
    front.interior = static_cast<int>(front.unknowns.size());
    front.unknowns.insert(front.unknowns.end(), boundary.begin(), boundary.end());
    std::vector<std::pair<int, int>> places;
    for (int i = 0; i < front.size(); ++i) places.emplace_back(front.unknowns[i], i);
    std::sort(places.begin(), places.end());
    for (const int unknown : parts)
      front.place.push_back(std::lower_bound(places.begin(), places.end(), std::pair{unknown, 0})->second);
    front.pivots.resize(front.interior);
    const int nobody = static_cast<int>(uses.size());
    front.columns.assign(whole(front.interior) + whole(front.boundary_size()), nobody);
    std::copy_n(front.unknowns.begin(), front.interior, front.columns.begin());
    std::copy(front.unknowns.begin() + front.interior, front.unknowns.end(),
              front.columns.begin() + whole(front.interior));
    front.rows.assign(front.columns.begin(), front.columns.begin() + whole(front.interior));
    front.factors = factors.size();
    factors.resize(factors.size() + FactorsOf<Factor>::entries(front));
    fronts.push_back(std::move(front));
    return static_cast<int>(fronts.size()) - 1;
  }

  int build(std::vector<int> part, std::span<const Vector3> middles, std::vector<int>& seen) {
    Front front;
    std::vector<int> parts;
    if (part.size() <= smallest_part) {
      for (const int e : part) parts.insert(parts.end(), elements[e].begin(), elements[e].end());
      front.elements = std::move(part);
      return add(std::move(front), parts);
    }
    auto [first, second] = cut(part, middles, seen);
    part = {};
    front.half = {build(std::move(first), middles, seen), build(std::move(second), middles, seen)};
    for (const int h : front.half)
      parts.insert(parts.end(), fronts[h].unknowns.begin() + fronts[h].interior, fronts[h].unknowns.end());
    return add(std::move(front), parts);
  }

  /// Of all planes in some directions the one that shares the fewest unknowns. `seen`: per unknown, zeros.
  std::array<std::vector<int>, 2> cut(const std::vector<int>& part, std::span<const Vector3> middles,
                                      std::vector<int>& seen) const {
    const std::size_t n = part.size(),
                      least = static_cast<std::size_t>((1 - largest_share) * static_cast<double>(n));
    std::vector<int> order = part, best;
    std::size_t at = n / 2, shared_least = ~std::size_t{0};
    std::vector<std::pair<double, int>> along(n);
    for (const Vector3& direction : directions) {
      for (std::size_t i = 0; i < n; ++i) along[i] = {dot(direction, middles[part[i]]), part[i]};
      std::sort(along.begin(), along.end());
      for (const int e : part)
        for (const int u : elements[e]) ++seen[u]; // elements that are still ahead
      std::size_t shared = 0;
      for (std::size_t i = 0; i < n; ++i) {
        for (const int u : elements[along[i].second]) {
          if (seen[u] > 0) ++shared, seen[u] = -seen[u]; // first met: counted as negative from now on
          if (++seen[u] == 0) --shared;
        }
        if (i + 1 >= least && n - i - 1 >= least && shared < shared_least) {
          shared_least = shared;
          at = i + 1;
          best.clear();
          for (const auto& [place, e] : along) best.push_back(e);
        }
      }
    }
    return {std::vector<int>(best.begin(), best.begin() + static_cast<long>(at)),
            std::vector<int>(best.begin() + static_cast<long>(at), best.end())};
  }

  void assemble(const Front& front, std::span<const double> matrices) {
    const std::size_t size = front.unknowns.size();
    work.assign(size * size, Factor(0));
    const int* place = front.place.data();
    const auto scatter = [&](const auto* from, int n) {
      for (int j = 0; j < n; ++j, from += n) {
        Factor* column = work.data() + size * place[j];
        for (int i = 0; i < n; ++i) column[place[i]] += static_cast<Factor>(from[i]);
      }
      place += n;
    };
    for (const int e : front.elements)
      scatter(matrices.data() + matrix[e], static_cast<int>(elements[e].size()));
    for (const int h : front.half)
      if (h >= 0) scatter(fronts[h].boundary.data(), fronts[h].boundary_size());
  }
};

Dissection::Dissection(int unknowns, std::vector<std::vector<int>> element_unknowns,
                       std::span<const Vector3> middles)
    : tree(std::make_unique<Tree>()) {
  openblas_set_num_threads(1); // presses run side by side, one thread each
  Tree& t = *tree;
  t.elements = std::move(element_unknowns);
  t.uses.assign(unknowns, 0);
  std::size_t entries = 0;
  for (const auto& element : t.elements) {
    t.matrix.push_back(entries);
    entries += element.size() * element.size();
    for (const int u : element) ++t.uses[u];
  }
  std::vector<int> all(t.elements.size()), seen(unknowns, 0);
  std::iota(all.begin(), all.end(), 0);
  t.build(std::move(all), middles, seen);
  t.uses = {};
  t.x.resize(unknowns + 1); // and 0 of nobody
  int largest = 0;
  for (const Front& front : t.fronts)
    largest = std::max(largest, whole(front.interior) + whole(front.boundary_size()));
  t.y.resize(largest);
}
Dissection::~Dissection() = default;
Dissection::Dissection(Dissection&&) noexcept = default;

bool Dissection::factorise(std::span<const double> element_matrices) {
  Tree& t = *tree;
  for (Front& front : t.fronts) {
    t.assemble(front, element_matrices);
    const int size = front.size(), interior = front.interior, boundary = front.boundary_size();
    Factor* a = t.work.data();
    const bool small = interior <= small_interior && size <= small_front;
    int* const pivots = front.pivots.data();
    if (!(small ? eliminate(a, size, interior, pivots) : eliminate_by_blocks(a, size, interior, pivots)))
      return false;
    std::copy_n(front.unknowns.begin(), interior, front.rows.begin());
    for (int i = 0; i < interior; ++i) std::swap(front.rows[i], front.rows[pivots[i] - 1]);
    const FactorsOf<Factor> f(front, t.factors.data() + front.factors);
    for (int j = 0; j < interior; ++j) {
      const Factor* column = a + static_cast<std::size_t>(j) * size;
      std::copy(column, column + j, f.upper + j * f.inner);
      f.per_pivot[j] = 1 / column[j];
      std::copy(column + j + 1, column + interior, f.lower + j * f.inner + j + 1);
      std::copy(column + interior, column + size, f.below + j * f.outer);
    }
    front.boundary.resize(static_cast<std::size_t>(boundary) * boundary);
    for (int j = 0; j < boundary; ++j) {
      const Factor* column = a + static_cast<std::size_t>(interior + j) * size;
      std::copy(column, column + interior, f.beside + static_cast<std::size_t>(j) * f.inner);
      std::copy(column + interior, column + size,
                front.boundary.data() + static_cast<std::size_t>(j) * boundary);
    }
  }
  return true;
}

void Dissection::solve(std::span<double> rhs) const {
  const Tree& t = *tree;
  auto &x = t.x, &y = t.y;
  // What is small against the largest entry would be lost in single precision, what is too small for it at
  // all: scaled to 1.
  double largest = 0;
  for (const double value : rhs) largest = std::max(largest, std::abs(value));
  if (!(largest > 0)) return;
  for (std::size_t i = 0; i < rhs.size(); ++i) x[i] = static_cast<Factor>(rhs[i] / largest);
  forward(t.fronts, t.factors.data(), x.data(), y.data());
  backward(t.fronts, t.factors.data(), x.data(), y.data());
  for (std::size_t i = 0; i < rhs.size(); ++i) rhs[i] = largest * x[i];
}

// Measured on 2,500 quadrilaterals and 5,000 hexahedra (bench fe): a front costs its arithmetic, and twice
// and a half as much an entry as a solution does, which waits for the memory of the factors.
double Dissection::factorisation_cost() const {
  constexpr double work_of_entry = 24,
                   of_front = 2.5; // additions and multiplications in the time of an entry
  double cost = 0, entries = 0;
  for (const Front& front : tree->fronts) {
    const double i = front.interior, b = front.boundary_size();
    entries += i * (i + 2 * b);
    cost += 2 * i * (i * i / 3 + i * b + b * b) / work_of_entry + of_front * (i + b) * (i + b);
  }
  return cost / entries;
}

} // namespace platen::fe
