#pragma once
// Confined compression: a sphere between rigid frictionless planes along x, y and z (SH section 2.2).
//
//   die          the planes along z approach, those along x and y stand still, touching
//   hydrostatic  all approach alike
//   triaxial     each as told, or not there
//
// Beside a plane an equal particle could stand: contacts are those of equal spheres in a simple cubic cell.

#include "fe/sphere_wedge.hpp"
#include "press/plan.hpp"

#include <numbers>

namespace platen::press {

/// delta/R0 from which on the meshes of wedges resolve a contact: of an elastic sphere the force of a die is
/// 2.2 times Hertz's at 1e-4.
inline constexpr double confined_resolved = 1e-3;

/// delta_bar at which the cell has the volume of the undeformed particle, 1 - pi/6 (die) and 1 - (pi/6)^{1/3}
/// (hydrostatic): no pores are left of a particle that keeps its volume.
inline constexpr double die_zero_porosity = 1 - std::numbers::pi / 6;
double hydrostatic_zero_porosity();

/// The largest volume of the undeformed particle, at its full density, over that of the cell.
inline constexpr double fullest = 1 / 0.9;

/// Volume of the cell between the planes at these overlaps (delta/R0 along z, x, y), over that of the
/// undeformed particle.
double cell_volume(const std::array<double, 3>& overlaps);

/// InvalidInput where a cell would be smaller than what is in it; `place` names the overlaps in the message.
void check_cell(const material::Material&, const std::array<double, 3>& overlaps, const std::string& place);

/// Die, hydrostatic and triaxial presses have a cell.
bool is_confined(const Experiment&);

/// Planes along z, x and y of which some are there, on a wedge; with how they move and step.
WedgePlan confined_plan(fe::Wedge, int elements, std::array<bool, 3> present, Motion, double step_max);

/// Of a triaxial press: the sum of the longest way of any plane between waypoints (R0).
double path_length(const Triaxial&);

} // namespace platen::press
