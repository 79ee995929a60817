#include "press/confined.hpp"

#include "press/by_overlap.hpp"
#include "press/case_card.hpp"
#include "press/confined_run.hpp"

#include <cmath>
#include <numbers>

namespace platen::press {

double zero_porosity(std::string_view experiment) {
  return experiment == "hydrostatic" ? 1 - std::cbrt(std::numbers::pi / 6) : 1 - std::numbers::pi / 6;
}

double cell_volume(const std::array<double, 3>& overlaps) {
  return 8 * (1 - overlaps[0]) * (1 - overlaps[1]) * (1 - overlaps[2]) / (4 * std::numbers::pi / 3);
}

double path_length(const Case& c) { return motion_of(c).end; }

bool is_confined(std::string_view experiment) {
  return experiment == "die" || experiment == "hydrostatic" || experiment == "triaxial";
}

ConfinedResult confined(const Case& given, const Progress& progress) {
  if (is_confined(given.experiment)) validate(given);
  Case c = given;
  if (c.experiment == "triaxial") c.delta_bar_max = path_length(c);
  return PressByOverlap<ConfinedRun>(c, progress)();
}

} // namespace platen::press
