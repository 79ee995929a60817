#pragma once
// What happens in a test, row by row.

#include "measure/specimen.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace platen::measure {

enum class Stage : unsigned char { approach, loading, hold, unloading, reloading, broken };
std::string_view name_of(Stage);

/// Where a particle broke: the force fell while the platens closed.
struct Break {
  std::size_t row = 0; ///< the first after the drop
  double fell = 0;     ///< share of the force that was lost
};

struct Stages {
  std::vector<Stage> of_row;
  double travel_noise_m = 0,
         force_noise_N = 0;      ///< standard deviations, from differences of neighbouring rows
  int holds = 0, unloadings = 0; ///< how many
  int loops = 0;                 ///< unloadings that are followed by a reloading
  std::optional<Break> broke;
  /// Where force begins, by a power law with onset and baseline fitted to the foot of the curve.
  double contact_travel_m = 0, contact_uncertainty_m = 0;
  double baseline_N = 0; ///< of the load cell out of contact; 0 where there is no such row
  std::size_t baseline_rows = 0;

  std::string words() const; ///< "1 hold, 2 loops, 1 unloading"
};

Stages stages_of(const Specimen&);

} // namespace platen::measure
