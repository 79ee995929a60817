#include "fe/equilibrium.hpp"

#include "fe/hexahedron.hpp"
#include "fe/quad.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace platen::fe {
namespace {

template <class Mesh> std::vector<Vector3> middles(const Mesh& mesh) {
  std::vector<Vector3> list;
  for (const auto& element : mesh.elements) {
    Vector3& middle = list.emplace_back();
    for (const int node : element)
      for (int k = 0; k < Mesh::dim; ++k) middle[k] += mesh.nodes[node][k] / Mesh::corners;
  }
  return list;
}

Cause cause_of(Outcome outcome) {
  switch (outcome) {
  case Outcome::done:
    return Cause::none;
  case Outcome::singular:
    return Cause::singular;
  case Outcome::steps:
    return Cause::stalled;
  }
  return Cause::none;
}

} // namespace

template <Element E>
Equilibrium<E>::Equilibrium(Mesh mesh, material::Model model, std::vector<Vector<Mesh::dim>> normals,
                            std::vector<int> copies, const ContactRule& rule, NewtonSettings settings_)
    : solid(std::move(mesh), std::move(model)), constraints(solid.mesh),
      contact(solid.mesh, std::move(normals), std::move(copies), rule, solid.model), settings(settings_),
      solver(constraints.unknowns(), constraints.element_unknowns(), middles(solid.mesh)),
      matrices(static_cast<std::size_t>(E::unknowns * E::unknowns) * solid.elements()),
      reduced(constraints.entries()) {}

template <Element E> StepReport Equilibrium<E>::solve(const Conditions<E>& given, std::vector<double>& x) {
  conditions = &given;
  return newton(*this, settings, x);
}

/// Forces of solid and contact. The residual is relative to the reactions; those so small that the rounding
/// of the strains would be a larger residual count as larger.
template <Element E> Cause Equilibrium<E>::evaluate(const std::vector<double>& x, Iterate& iterate) {
  constraints.expand(x, u);
  switch (solid.evaluate(u, conditions->start, answer)) {
  case Evaluation::done:
    break;
  case Evaluation::inverted_element:
    return Cause::inverted_element;
  case Evaluation::refused_material:
    return Cause::refused_material;
  }
  contact.add_forces(u, conditions->heights, conditions->memory, answer.force, iterate.touching);
  constraints.reduce(answer.force, iterate.force);
  double all = 0, free = 0;
  for (const double f : answer.force) all += f * f;
  for (const double f : iterate.force) free += f * f;
  const double rounding = 20 * std::numeric_limits<double>::epsilon() * material::initial_E(solid.model);
  const double least = rounding / settings.relative_residual_tolerance;
  iterate.relative = std::sqrt(free / std::max(all - free, least * least));
  if (!std::isfinite(iterate.relative)) return Cause::inverted_element;
  iterate.zones.clear();
  for (const auto& update : answer.updates) iterate.zones.push_back(update.zone);
  return Cause::none;
}

template <Element E> Cause Equilibrium<E>::linearise(const Iterate& iterate) {
  // Far from equilibrium perfectly plastic points at the contact edge give way to any force, and corrections
  // turn the small elements there inside out. The addition goes with the residual: the last corrections are
  // Newton's own.
  relative = iterate.relative;
  solid.linearise(answer, std::min(0.1 * relative, 0.3), matrices);
  {
    Stopwatch watch(answer.times.assembly_s);
    contact.add_tangent(iterate.touching, conditions->memory, matrices);
    constraints.reduce_matrices(matrices, reduced);
  }
  const Cause cause = cause_of(solver.matrix(reduced));
  answer.times.factorisation_s = solver.factorisation_s;
  return cause;
}

template <Element E> Cause Equilibrium<E>::solve(std::span<double> x) {
  const double factorised_s = solver.factorisation_s;
  Stopwatch watch(answer.times.solve_s);
  // The linear residual goes into the next iterate. Far away kinks leave more of it than a tenth; near by a
  // hundredth leads to the tolerance.
  const Cause cause = cause_of(solver.solve(x, std::clamp(relative, 1e-2, 1e-1)));
  answer.times.factorisation_s = solver.factorisation_s;
  answer.times.solve_s -= solver.factorisation_s - factorised_s;
  return cause;
}

template class Equilibrium<Quad>;
template class Equilibrium<Hexahedron>;

} // namespace platen::fe
