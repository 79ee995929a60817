#pragma once
// Plastic flow of second order in the step, at the price of first.
//
// Each equilibrium is found by one backward Euler step of the material. Taken from the equilibrium before,
// that is of first order: 180 steps to delta_bar = 0.5 leave a base-case granule 1.2 % too soft. Here the
// step to the equilibrium at t_k starts almost halfway between t_{k-1} and t_k, from a state that continues
// the flow met at t_{k-1}; so each return is the middle of the flow it stands for (the midpoint rule, with
// equilibria at the midpoints). A point that begins to flow starts from its last equilibrium instead; one
// that ceases to has flowed for the first part of the step. (To start it from its last equilibrium again,
// once it is seen not to flow, makes the residual jump: Newton took twice the iterations.)

#include "fe/solid.hpp"

namespace platen::press {

/// What a Gauss point did in the last step, from the start of its return to the equilibrium.
template <fe::Element E> struct PointFlow {
  using State = typename E::State;
  State start;
  double start_time = 0;
  double ahead_dv = 0,
         ahead_dw = 0;   ///< plastic increments by which the start ran ahead of the equilibrium before
  double dv = 0, dw = 0; ///< plastic increments of the return
  bool flows = false;    ///< at the equilibrium
  bool steady = false;   ///< and at the one before
  // At the equilibrium:
  State state;
  material::TrialInvariants elastic{0, 0};
  typename E::Gradient F{};
  typename E::Stress direction{}; ///< deviator of the stress over its q
};

/// The start of the next return, from the equilibrium at `time` to that at `next_time`: almost halfway, if
/// the point has flowed in both last steps and the planes go on.
template <fe::Element E> PointFlow<E> next_return(const PointFlow<E>&, double time, double next_time);

/// The plastic shear on which the mean q of two equilibria does work: flow `ahead` along the direction of the
/// stress at the first, a return by dw along that at the second, which the material has turned from it by
/// phi. Up to a right angle the stress turns evenly along the yield surface,
///   |ahead a + dw b| (phi/2)/sin(phi/2);
/// beyond, it crosses the elastic domain, and flow to and fro cancels: the trapezoidal rule,
///   (ahead + dw) (1 + cos phi)/2.
double working_shear(double ahead, double dw, double cos_phi);

/// Takes what the solid found at the equilibrium into the flow, and returns what was dissipated since the one
/// before (Pa, per reference volume): the plastic work, less what the change of moduli and of the unloaded
/// volume adds to the stored energy at fixed strain.
template <fe::Element E>
double accept(PointFlow<E>&, const PointFlow<E>& before, const material::Model&, const fe::Response<E>&,
              int point);

} // namespace platen::press
