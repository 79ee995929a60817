#pragma once
// A solid with what it was last asked, for tests.

#include "fe/solid.hpp"

#include <vector>

namespace platen::test {

template <fe::Element E> struct Held {
  fe::Solid<E> solid;
  std::vector<typename E::State> start;
  fe::Response<E> response;
  std::vector<double> tangent;

  Held(typename E::Mesh mesh, const material::Model& model)
      : solid(std::move(mesh), model), start(solid.points()),
        tangent(E::unknowns * E::unknowns * solid.elements()) {}

  fe::Evaluation evaluate(const std::vector<double>& u) { return solid.evaluate(u, start, response); }
  void linearise(double added = 0) { solid.linearise(response, added, tangent); }
  /// What was reached is where the next evaluation starts.
  void commit() {
    for (int i = 0; i < solid.points(); ++i) start[i] = response.state(i);
  }
};

template <fe::Element E> std::vector<material::Zone> zones(const Held<E>& held) {
  std::vector<material::Zone> list;
  for (const auto& point : held.response.updates) list.push_back(point.zone);
  return list;
}

/// Displacement components of an element, in the order of its forces.
template <fe::Element E>
std::array<int, E::unknowns> components(const std::array<int, E::Mesh::corners>& element) {
  std::array<int, E::unknowns> list;
  for (int i = 0; i < E::unknowns; ++i) list[i] = E::Mesh::dim * element[i / E::Mesh::dim] + i % E::Mesh::dim;
  return list;
}

} // namespace platen::test
