#pragma once
// What the Gauss points of a solid add up to: a row of the curve, flags, statistics.

#include "fe/newton.hpp"
#include "press/midpoint_flow.hpp"
#include "press/simple.hpp"

#include <string>
#include <vector>

namespace platen::press {

/// Integrals over the solid (R0^3 Pa).
struct Totals {
  double stored = 0, dissipated = 0; ///< dissipated: since the equilibrium before
};

/// Takes the solid's last evaluation into the flow of its points, and fills zones, densities and largest
/// stresses of the row.
template <class Solid>
Totals account_points(const Solid&, std::vector<PointFlow<Solid>>&,
                      const std::vector<PointFlow<Solid>>& before, CurvePoint& row);

/// Bounds of the material description that were active somewhere, in plain sentences.
template <class Solid> std::vector<std::string> flags_of(const Solid&, const std::vector<PointFlow<Solid>>&);

/// Invariants of the plastic Hencky strain -ln(C_p^-1)/2 of a point.
material::TrialInvariants plastic_strain(const fe::PointState&);
material::TrialInvariants plastic_strain(const fe::SpatialPointState&);

/// Counts one step, converged or not.
void count(const fe::StepReport&, Statistics&);

template <class Solid>
Statistics statistics_of(Statistics counted, const Solid& solid, std::size_t elements, int unknowns) {
  counted.material_s = solid.times.material_s;
  counted.assembly_s = solid.times.assembly_s;
  counted.factorisation_s = solid.times.factorisation_s;
  counted.solve_s = solid.times.solve_s;
  counted.elements = static_cast<int>(elements);
  counted.unknowns = unknowns;
  counted.local_continuations = solid.counts.bracketed;
  return counted;
}

} // namespace platen::press
