#pragma once
// What a virtual experiment is: a particle, a path, a mesh, the output wanted. Each experiment has its own
// fields; its card, its checks and what it becomes (press/plan.hpp) are in the file of its name.

#include "material/models.hpp"

#include <limits>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace platen::press {

/// What presses by overlap share: planes approach to delta_bar_max.
struct ByOverlap {
  double delta_bar_max = 0.5;           ///< largest delta/R0
  std::vector<double> unload_from = {}; ///< delta_bar at which a branch unloads, ascending
  bool reload = false;                  ///< each unloaded branch is loaded again
  int elements = 2500;                  ///< wanted number of elements; the mesh comes close to it
  double step_max = 0.005;              ///< largest step of delta_bar
  std::vector<double> fields_at = {};   ///< delta_bar at which fields are kept, ascending
};

/// A sphere between two rigid frictionless planes, or two equal spheres (ES section 4).
struct Simple : ByOverlap {
  static constexpr std::string_view name = "simple";
};

/// Between two planes and four walls that stand still, touching (SH section 2.2).
struct Die : ByOverlap {
  static constexpr std::string_view name = "die";
  Die();
};

/// Between six planes that approach alike.
struct Hydrostatic : ByOverlap {
  static constexpr std::string_view name = "hydrostatic";
  Hydrostatic();
};

/// Planes that go from waypoint to waypoint; no list, no plane.
struct Triaxial {
  static constexpr std::string_view name = "triaxial";
  std::vector<double> delta_bar_z, delta_bar_x, delta_bar_y; ///< delta/R0 along z, x, y
  int elements = 5000;
  double step_max = 0.01;
  std::vector<double> fields_at; ///< by the way that the plane that moves most has gone
};

/// Two equal spheres, or a sphere on a rigid plane, at loads where the contact radius is a few per cent of
/// the sphere's (WG section 3). The path goes by force or by overlap; the first limit met ends it.
struct Local {
  static constexpr std::string_view name = "local";
  double force_max_N = 100; ///< may be infinite
  double delta_bar_max = 0.5;
  std::vector<double> unload_from_N,
      unload_from; ///< forces and delta_bar at which a branch unloads, ascending
  bool reload = false;
  double first_contact_bar = 0.0015; ///< contact radius/R0 from which on `edges` edges lie under the contact
  int edges = 20;                    ///< of elements under the contact, at least
  std::vector<double> fields_at_N, fields_at; ///< where fields and pressure profiles are kept, ascending
};

using Experiment = std::variant<Simple, Local, Die, Hydrostatic, Triaxial>;

/// One virtual experiment, as a case card describes it.
struct Case {
  material::Material material;
  double radius_m = 1e-3;
  Experiment experiment = Simple{};
};

std::string_view name_of(const Experiment&);
/// What presses by overlap share; null for others.
const ByOverlap* by_overlap(const Experiment&);
ByOverlap* by_overlap(Experiment&);

} // namespace platen::press
