#pragma once
// Confined compression: a sphere between rigid frictionless planes along x, y and z (SH section 2.2).
//
//   die          the planes along z approach, those along x and y stand still, touching
//   hydrostatic  all approach alike
//   triaxial     each as told, or not there
//
// Beside a plane an equal particle could stand: contacts are those of equal spheres in a simple cubic cell.

#include "fe/vector3.hpp"
#include "press/simple.hpp"

#include <string>
#include <vector>

namespace platen::press {

/// A picture of the wedge: lengths in units of R0. Values are element means.
struct SpatialSnapshot {
  double delta_bar = 0;
  Branch branch = Branch::loading;
  std::array<double, 3> plane{}; ///< where the planes along x, y, z lie; 0: none
  std::vector<fe::Vector3> nodes, displacement;
  std::vector<std::array<int, 8>> hexes;
  std::vector<std::array<int, 4>> surface;        ///< faces on the sphere
  std::vector<std::array<fe::Vector3, 3>> copies; ///< matrices that map the wedge onto the whole
  std::vector<std::array<double, 3>> pressure;    ///< per face: of contact with the planes x, y, z (Pa)
  std::vector<std::array<double, 6>> stress;      ///< Cauchy, tension positive (Pa): xx yy zz xy yz zx
  std::vector<double> p, q;                       ///< tension positive (Pa)
  std::vector<double> rho_r, phi;
  std::vector<Zone> zone; ///< that most of the Gauss points are in
  /// Invariants of the plastic Hencky strain -ln(C_p^-1)/2: of the shape reached, not accumulated on the way.
  std::vector<double> plastic_strain_v, plastic_strain_q;
};

struct ConfinedResult : Result {
  std::vector<SpatialSnapshot> spatial;
};

/// As simple(); `experiment` of the case says how. A case with experiment "simple" is pressed in space too,
/// for comparison. Of a triaxial case delta_bar_max is not read: the press goes to the end of its history.
ConfinedResult confined(const Case&, const Progress& = {});

/// delta_bar at which the cell has the volume of the undeformed particle, 1 - pi/6 (die) and 1 - (pi/6)^{1/3}
/// (hydrostatic): no pores are left of a particle that keeps its volume.
double zero_porosity(std::string_view experiment);

/// The largest volume of the undeformed particle, at its full density, over that of the cell.
inline constexpr double fullest = 1 / 0.9;

/// Volume of the cell between the planes at these overlaps (delta/R0 along x, y, z), over that of the
/// undeformed particle.
double cell_volume(const std::array<double, 3>& overlaps);

/// Of a triaxial press: the sum of the longest way of any plane between waypoints (R0).
double path_length(const Case&);

bool is_confined(std::string_view experiment);

} // namespace platen::press
