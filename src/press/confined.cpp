#include "press/confined.hpp"

#include "core/error.hpp"
#include "press/by_overlap.hpp"
#include "press/confined_run.hpp"

#include <numbers>

namespace platen::press {

double zero_porosity(std::string_view experiment) {
  return experiment == "hydrostatic" ? 1 - std::cbrt(std::numbers::pi / 6) : 1 - std::numbers::pi / 6;
}

ConfinedResult confined(const Case& c, const Progress& progress) {
  return PressByOverlap<ConfinedRun>(c, progress)();
}

} // namespace platen::press
