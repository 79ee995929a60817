#include "material/point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace platen::material {

MaterialPoint strained(const Model& model, const MaterialPoint& from, const std::array<double, 3>& increment,
                       ModuliScheme scheme) {
  MaterialPoint to = from;
  std::array<double, 3> trial = from.elastic;
  for (int A = 0; A < 3; ++A) {
    trial[A] += increment[A];
    to.total[A] += increment[A];
  }
  if (scheme == ModuliScheme::after_step) to.last = update_with_old_moduli(model, trial, from.phi);
  else (void)update(model, {&trial, 1}, {&from.phi, 1}, {&to.last, 1});
  if (is_refused(to.last.status)) return to;
  to.elastic = to.last.eps;
  to.phi = to.last.phi;
  return to;
}

// Newton kept inside a bracket: the lateral stress rises with the lateral strain, but not everywhere at a
// rate worth following (at an apex it does not rise at all).
MaterialPoint strained_axially(const Model& model, const MaterialPoint& from, double increment,
                               double lateral, ModuliScheme scheme) {
  constexpr int iterations_max = 200;
  constexpr double strain_tolerance = 1e-15; // rounding of the strains themselves
  const double E = initial_E(model), nu = initial_nu(model);
  const double size = std::abs(increment) + std::abs(from.last.sigma[1] - lateral) / E;
  double low = -std::numeric_limits<double>::infinity(), high = -low;
  double x = -nu * increment;
  MaterialPoint to;
  for (int i = 0; i < iterations_max; ++i) {
    to = strained(model, from, {increment, x, x}, scheme);
    if (is_refused(to.last.status)) return to;
    const double gap = to.last.sigma[1] - lateral, slope = to.last.D[1][1] + to.last.D[1][2];
    if (std::abs(gap) <= strain_tolerance * slope) return to;
    (gap > 0 ? high : low) = x;
    double next = x - gap / slope;
    if (!(std::abs(next - x) <= 2 * size)) next = x - std::copysign(2 * size, gap);
    if (!(next > low && next < high)) next = (low + high) / 2;
    if (std::abs(next - x) <= strain_tolerance) return to;
    x = next;
  }
  to.last.status = Status::refused;
  return to;
}

} // namespace platen::material
