#pragma once
// What a virtual experiment is: a particle, a path, a mesh, the output wanted.

#include "material/models.hpp"

#include <string>
#include <vector>

namespace platen::press {

/// One virtual experiment, as a case card describes it.
struct Case {
  std::string experiment = "simple";
  material::Material material;
  double radius_m = 1e-3;
  double delta_bar_max = 0.5;      ///< largest delta/R0, in (0, 0.5]
  std::vector<double> unload_from; ///< delta_bar at which a branch unloads, ascending
  bool reload = false;             ///< each unloaded branch is loaded again
  int elements = 5000;             ///< wanted number of elements; the mesh comes close to it
  double step_max = 0.005;         ///< largest step of delta_bar
  std::vector<double> fields_at;   ///< delta_bar at which fields are kept, ascending
};

} // namespace platen::press
