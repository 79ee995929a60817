#pragma once
// Drives a press along its path: loads in steps to where it halts, by time or by force, and unloads copies of
// the loaded state.

#include "press/press.hpp"
#include "press/step.hpp"

namespace platen::press {

/// Called after each step of loading, and at the end.
template <fe::Element E> struct Observer {
  std::function<void(const Stepper<E>&, const State<E>&)> look = [](const auto&, const auto&) {};
  std::function<void(Result&)> report = [](Result&) {};
};

template <fe::Element E> Result drive(const Case&, const Plan<E>&, const Progress&, const Observer<E>& = {});

} // namespace platen::press
