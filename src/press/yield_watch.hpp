#pragma once
// What the local press looks for while it loads: first yield on the axis and at the contact edge, and the
// load at which the plastic zone breaks through to the free surface.

#include "press/local.hpp"
#include "press/sphere_run.hpp"

#include <utility>

namespace platen::press {

/// Friction angle (degrees) and uniaxial compressive strength (Pa) that a model shares with linear
/// Drucker-Prager in triaxial compression: WG (5)-(7), (14), (15). Zeros where there are none.
std::pair<double, double> drucker_prager_strength(const material::Model&);

class YieldWatch {
 public:
  YieldWatch(const Case&, const SphereRun&);
  /// After each step of loading.
  void look(const SphereRun&);
  void report(LocalResult&) const;

 private:
  void look_for_onset(const SphereRun&);
  void look_for_break_through(const SphereRun&);
  double joining_strain(const std::vector<double>& plastic_strain, double a) const;

  struct Candidate { ///< for an onset: of the last step before it
    std::optional<Onset> last;
    bool met = false;
  };
  static void extend(Candidate&, double force_N, std::array<double, 2> place, double reserve);
  double edge_reserve(const SphereRun&) const;

  const Case& press_case;
  std::vector<std::array<double, 2>> places;     ///< of the Gauss points, R0: r, depth below the pole
  std::vector<std::vector<int>> neighbours;      ///< elements that share an edge
  std::vector<std::pair<int, double>> at_sphere; ///< elements at the sphere, their polar angle
  Candidate axis, edge;
  BreakThrough joined{0, 0}; ///< of the last step
  std::vector<BreakThrough> broken;
};

} // namespace platen::press
