#pragma once
// What the mirrors leave free: the unknowns of a mesh are displacements along directions of its nodes, so
// mirrors that are no coordinate planes are exact.

#include "fe/mesh.hpp"

#include <span>
#include <vector>

namespace platen::fe {

template <class Mesh> class Constraints {
 public:
  static constexpr int dim = Mesh::dim;

  explicit Constraints(const Mesh&);

  int unknowns() const { return count; }
  /// The unknowns of each element, in the order of its reduced matrix.
  const std::vector<std::vector<int>>& element_unknowns() const { return lists; }
  /// Numbers in all reduced element matrices.
  std::size_t entries() const { return reduced_entries; }

  /// Displacement components (of each node, in turn) of free displacements.
  void expand(std::span<const double> x, std::vector<double>& u) const;
  /// The work-conjugate of expand: forces on the unknowns from forces on the components.
  void reduce(std::span<const double> force, std::vector<double>& on_unknowns) const;
  /// Element matrices (by columns, of components) to those of the unknowns alone.
  void reduce_matrices(std::span<const double> matrices, std::span<double> reduced) const;
  /// Adds to the unknowns of a node what moves it by a vector, as far as it is free.
  void move(int node, const Vector<dim>& by, std::span<double> x) const;

 private:
  struct Free {               ///< what a node may do
    int first = 0, count = 0; ///< unknowns
    std::array<Vector<dim>, dim> along{};
  };
  std::vector<Free> free_of; ///< per node
  std::vector<std::array<int, Mesh::corners>> elements;
  std::vector<char> plain; ///< per element: all its components are unknowns
  std::vector<std::vector<int>> lists;
  int count = 0;
  std::size_t reduced_entries = 0;
};

} // namespace platen::fe
