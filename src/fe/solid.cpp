#include "fe/solid.hpp"

#include "fe/hexahedron.hpp"
#include "fe/quad.hpp"

#include <algorithm>
#include <cmath>

namespace platen::fe {

template <Element E>
Solid<E>::Solid(typename E::Mesh mesh_, material::Model model_)
    : mesh(std::move(mesh_)), model(std::move(model_)) {
  for (const auto& element : mesh.elements) {
    std::array<Vector<dim>, E::Mesh::corners> corners;
    for (std::size_t a = 0; a < corners.size(); ++a) corners[a] = mesh.nodes[element[a]];
    shapes.push_back(E::shape(corners));
  }
}

template <Element E> Vector<Solid<E>::dim> Solid<E>::place(int point) const {
  // Gauss points lie towards the corners in their order, 1/sqrt(3) of the way from the middle.
  const auto& element = mesh.elements[point / E::points];
  Vector<dim> x{};
  for (int a = 0; a < E::Mesh::corners; ++a) {
    double N = 1;
    for (int k = 0; k < dim; ++k) {
      const auto side = [k](int corner) {
        return k == 2 ? corner / 4 : k == 1 ? corner % 4 / 2 : (corner % 4 + 1) / 2 % 2;
      };
      N *= (1 + (side(a) == side(point % E::points) ? 1 : -1) / std::sqrt(3.0)) / 2;
    }
    x = x + N * mesh.nodes[element[a]];
  }
  return x;
}

template <Element E>
Evaluation Solid<E>::evaluate(std::span<const double> u, std::span<const State> start, Response<E>& r) const {
  r.kinematics.resize(elements());
  r.updates.resize(points());
  r.trial.resize(points());
  r.phi.resize(points());
  {
    Stopwatch watch(r.times.assembly_s);
    for (int e = 0; e < elements(); ++e) {
      std::array<double, E::unknowns> local;
      for (int a = 0; a < E::Mesh::corners; ++a)
        for (int k = 0; k < dim; ++k) local[dim * a + k] = u[dim * mesh.elements[e][a] + k];
      if (!E::deform(shapes[e], local.data(), r.kinematics[e])) return Evaluation::inverted_element;
      E::strains(r.kinematics[e], &start[E::points * e], &r.trial[E::points * e]);
    }
  }
  for (int i = 0; i < points(); ++i) r.phi[i] = start[i].phi;
  {
    Stopwatch watch(r.times.material_s);
    const auto batch = material::update(model, r.trial, r.phi, r.updates);
    r.counts.plastic += batch.plastic;
    r.counts.bracketed += batch.bracketed;
    r.counts.refused += batch.refused;
    if (batch.refused > 0) return Evaluation::refused_material;
  }
  Stopwatch watch(r.times.assembly_s);
  r.force.assign(components(), 0.0);
  for (int e = 0; e < elements(); ++e) {
    std::array<double, E::unknowns> local;
    E::forces(shapes[e], r.kinematics[e], &r.updates[E::points * e], local.data());
    for (int a = 0; a < E::Mesh::corners; ++a)
      for (int k = 0; k < dim; ++k) r.force[dim * mesh.elements[e][a] + k] += local[dim * a + k];
  }
  return Evaluation::done;
}

template <Element E>
void Solid<E>::linearise(Response<E>& r, double added, std::span<double> matrices) const {
  Stopwatch watch(r.times.assembly_s);
  const double two_G_added = added * material::initial_E(model) / (1 + material::initial_nu(model));
  for (int e = 0; e < elements(); ++e)
    E::tangent(shapes[e], r.kinematics[e], &r.updates[E::points * e], two_G_added,
               &matrices[static_cast<std::size_t>(E::unknowns * E::unknowns) * e]);
}

template class Solid<Quad>;
template class Solid<Hexahedron>;

} // namespace platen::fe
