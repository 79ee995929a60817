#pragma once
// One step of a press: from a complete state to the equilibrium at another time.

#include "fe/equilibrium.hpp"
#include "press/account.hpp"
#include "press/plan.hpp"

#include <vector>

namespace platen::press {

/// Everything that a press needs to go on from here: copying it back restores everything. Lengths in units of
/// R0, stresses in Pa.
template <fe::Element E> struct State {
  double time = 0, step = 0;     ///< step: the last one, whose displacement change is extrapolated
  std::vector<double> x, change; ///< free displacements
  std::vector<PointFlow<E>> points;
  fe::ContactMemory contact;
  CurvePoint row, row_before; ///< without branch
};

template <fe::Element E> struct Step {
  fe::StepReport report;
  State<E> state; ///< where it converged
};

template <fe::Element E> class Stepper {
 public:
  Stepper(const material::Model&, double radius_m, Plan<E>);

  const Plan<E> plan; ///< without its mesh, which the solid has
  State<E> at_rest() const;

  /// One step to a time, forwards or backwards; the given state stays what it is. Afterwards solid() and
  /// response() are of the new state.
  Step<E> operator()(const State<E>&, double time);
  /// The next step does not depend on those that were taken: a solver's factors go.
  void forget() { equilibrium.forget(); }

  const fe::Solid<E>& solid() const { return equilibrium.solid; }
  const fe::Response<E>& response() const { return equilibrium.response(); }
  /// Displacement components.
  std::vector<double> displacement(const State<E>&) const;
  /// Pressures of a plane (along z, x, y), on the mesh alone.
  std::vector<fe::FacePressure> pressures(const State<E>&, int axis) const;

  double radius_m, sigma_ref;

 private:
  std::vector<double> heights(double time) const;
  void account(State<E>& next, const State<E>& before, const fe::ContactMemory&, int iterations) const;
  double far_field(const CurvePoint&) const;

  fe::Equilibrium<E> equilibrium;
};

} // namespace platen::press
