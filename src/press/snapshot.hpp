#pragma once
// Pictures of a state.

#include "press/result.hpp"
#include "press/step.hpp"

namespace platen::press {

/// Of the state that the stepper reached last.
template <fe::Element E> SnapshotOf<E> snapshot(const Stepper<E>&, const State<E>&, Branch);
/// Contact pressure over the radius.
PressureProfile profile(const Stepper<fe::Quad>&, const State<fe::Quad>&);

} // namespace platen::press
