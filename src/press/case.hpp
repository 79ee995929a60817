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
  // The local press goes by force as well, and ends at whichever of force_max_N and delta_bar_max is met
  // first.
  double force_max_N = 100;          ///< largest force; may be infinite
  std::vector<double> unload_from_N; ///< forces at which a branch unloads, ascending
  std::vector<double> fields_at_N;   ///< forces at which fields and pressure profiles are kept, ascending
  double first_contact_bar = 0.0015; ///< contact radius/R0 from which on `edges` edges lie under the contact
  int edges = 20;                    ///< of elements under the contact, at least
};

} // namespace platen::press
