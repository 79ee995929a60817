#include "fe/constraints.hpp"

#include <algorithm>

namespace platen::fe {

/// A node on mirrors keeps to the directions that lie in all of them.
template <class Mesh> Constraints<Mesh>::Constraints(const Mesh& mesh) : elements(mesh.elements) {
  std::vector<std::vector<Vector<dim>>> held(mesh.nodes.size()); // orthonormal
  const auto without = [](Vector<dim> n, const std::vector<Vector<dim>>& basis) {
    for (const auto& b : basis) n = n - dot(n, b) * b;
    return n;
  };
  for (const auto& mirror : mesh.mirrors)
    for (const int node : mirror.nodes) {
      const Vector<dim> n = without(mirror.normal, held[node]);
      if (norm(n) > 1e-6) held[node].push_back(unit(n));
    }
  for (auto basis : held) {
    Free& f = free_of.emplace_back();
    f.first = count;
    // The axes that stand out most from what is held already.
    while (static_cast<int>(basis.size()) < dim) {
      Vector<dim> farthest{};
      for (int k = 0; k < dim; ++k) {
        Vector<dim> axis{};
        axis[k] = 1;
        if (const auto n = without(axis, basis); norm(n) > norm(farthest) + 1e-9) farthest = n;
      }
      basis.push_back(f.along[f.count++] = unit(farthest));
    }
    count += f.count;
  }
  for (const auto& element : elements) {
    auto& list = lists.emplace_back();
    bool all = true;
    for (const int node : element) {
      for (int k = 0; k < free_of[node].count; ++k) list.push_back(free_of[node].first + k);
      all = all && held[node].empty();
    }
    plain.push_back(all);
    reduced_entries += list.size() * list.size();
  }
}

template <class Mesh>
void Constraints<Mesh>::expand(std::span<const double> x, std::vector<double>& u) const {
  u.assign(dim * free_of.size(), 0.0);
  for (std::size_t n = 0; n < free_of.size(); ++n)
    for (int k = 0; k < free_of[n].count; ++k)
      for (int i = 0; i < dim; ++i) u[dim * n + i] += x[free_of[n].first + k] * free_of[n].along[k][i];
}

template <class Mesh>
void Constraints<Mesh>::reduce(std::span<const double> force, std::vector<double>& on_unknowns) const {
  on_unknowns.resize(count);
  for (std::size_t n = 0; n < free_of.size(); ++n)
    for (int k = 0; k < free_of[n].count; ++k) {
      double sum = 0;
      for (int i = 0; i < dim; ++i) sum += force[dim * n + i] * free_of[n].along[k][i];
      on_unknowns[free_of[n].first + k] = sum;
    }
}

template <class Mesh>
void Constraints<Mesh>::reduce_matrices(std::span<const double> matrices, std::span<double> reduced) const {
  constexpr int size = dim * Mesh::corners;
  double* into = reduced.data();
  const double* K = matrices.data();
  for (std::size_t e = 0; e < elements.size(); ++e, K += size * size) {
    if (plain[e]) {
      into = std::copy(K, K + size * size, into);
      continue;
    }
    for (int b = 0; b < Mesh::corners; ++b)
      for (int l = 0; l < free_of[elements[e][b]].count; ++l) {
        const Vector<dim>& d = free_of[elements[e][b]].along[l];
        std::array<double, size> column{};
        for (int j = 0; j < dim; ++j)
          for (int i = 0; i < size; ++i) column[i] += K[size * (dim * b + j) + i] * d[j];
        for (int a = 0; a < Mesh::corners; ++a)
          for (int k = 0; k < free_of[elements[e][a]].count; ++k) {
            const Vector<dim>& c = free_of[elements[e][a]].along[k];
            *into = 0;
            for (int i = 0; i < dim; ++i) *into += c[i] * column[dim * a + i];
            ++into;
          }
      }
  }
}

template <class Mesh>
void Constraints<Mesh>::move(int node, const Vector<dim>& by, std::span<double> x) const {
  const Free& f = free_of[node];
  for (int k = 0; k < f.count; ++k) x[f.first + k] += dot(f.along[k], by);
}

template class Constraints<SectionMesh>;
template class Constraints<WedgeMesh>;

} // namespace platen::fe
