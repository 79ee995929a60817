#pragma once
// Plastic flow of second order in the step, at the price of first.
//
// Each equilibrium is found by one backward Euler step of the material. Taken from the equilibrium before,
// that is of first order: 180 steps to delta_bar = 0.5 leave a base-case granule 1.2 % too soft. Here the
// step to the equilibrium at t_k starts almost halfway between t_{k-1} and t_k, from a state that continues
// the flow met at t_{k-1}; so each return is the middle of the flow it stands for (the midpoint rule, with
// equilibria at the midpoints). A point that begins to flow starts from its last equilibrium instead.

#include "fe/axisymmetric.hpp"
#include "fe/hexahedral.hpp"

#include <array>
#include <utility>

namespace platen::press {

/// What a Gauss point of a solid did in the last step, from the start of its return to the equilibrium.
template <class Solid> struct PointFlow {
  using State = typename Solid::State;
  State start;
  double start_time = 0; ///< delta_bar
  double ahead_dv = 0,
         ahead_dw = 0;   ///< plastic increments by which the start ran ahead of the equilibrium before
  double dv = 0, dw = 0; ///< plastic increments of the return
  bool flows = false;    ///< at the equilibrium
  bool steady = false;   ///< and at the one before
  // At the equilibrium:
  State state;
  material::TrialInvariants elastic{0, 0};
  decltype(std::declval<Solid>().cauchy(0)) direction{}; ///< deviator of the stress over its q
};

/// The start of the next return, from the equilibrium at `time` to that at `next_time`: almost halfway, if
/// the point has flowed in both last steps and the plane goes on.
template <class Solid> PointFlow<Solid> next_return(const PointFlow<Solid>&, double time, double next_time);

/// The state that flow at a constant rate from a to b reaches after `factor` of that way: Cp_inv along the
/// geodesic of symmetric positive matrices, A (A^-1 B)^factor, phi in proportion.
fe::PointState continued(const fe::PointState& a, const fe::PointState& b, double factor);
fe::SpatialPointState continued(const fe::SpatialPointState& a, const fe::SpatialPointState& b,
                                double factor);

/// Takes what the solid found at the equilibrium into the flow, and returns what was dissipated since the one
/// before (Pa, per reference volume): the trapezoidal plastic power, less what the change of moduli and of
/// the unloaded volume adds to the stored energy at fixed strain.
template <class Solid>
double accept(PointFlow<Solid>&, const PointFlow<Solid>& before, const Solid&, int point);

} // namespace platen::press
