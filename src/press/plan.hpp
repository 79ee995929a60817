#pragma once
// What an experiment becomes: a mesh, planes and their motion, halts, and rules of stepping.

#include "fe/contact.hpp"
#include "fe/hexahedron.hpp"
#include "fe/newton.hpp"
#include "fe/quad.hpp"
#include "press/case.hpp"

#include <functional>

namespace platen::press {

/// How planes move with the time of the press, which counts in delta_bar unless they go ways of their own.
struct Motion {
  std::function<std::array<double, 3>(double)> overlaps_at; ///< delta/R0 along z, x, y
  std::vector<double> turns;                                ///< times at which it changes its direction
  std::vector<char> retreats;                               ///< whether the planes move apart up to a turn
};

/// Steps of time. The contact starts as a point, with infinitely many changes of the contact near 0: so a
/// first step, and the largest in relation to the time.
struct StepRule {
  double first = 0, relative_max = 0;
  double largest = std::numeric_limits<double>::infinity();
  double growth = 1.5;     ///< from one to the next
  double smallest = 1e-7;  ///< below it a step is given up
  int unloading = 24;      ///< about as many steps has a branch
  double separated = 2e-3; ///< a branch ends below this share of the force it started from
};

/// Where loading halts, by time or by force; it ends where either end is met.
struct Halts {
  double end = 0, force_end_N = std::numeric_limits<double>::infinity();
  std::vector<double> unload_from = {}, fields_at = {};     ///< times
  std::vector<double> unload_from_N = {}, fields_at_N = {}; ///< forces
  bool reload = false;
};

template <fe::Element E> struct Plan {
  using Mesh = typename E::Mesh;
  Mesh mesh = {};
  std::vector<fe::Vector<Mesh::dim>> normals = {}; ///< of the planes that are no images of others
  std::vector<int> copies = {};                    ///< of the mesh, that press on each
  std::array<int, 3> plane_of{0, -1, -1}; ///< along z, x, y; images count as what they are of; -1: none
  double halves = 1;                      ///< meshes in half a sphere
  int equator_node = 0;                   ///< on the x axis, or an image of it
  fe::ContactRule contact = {};
  fe::NewtonSettings newton = {};
  Motion motion = {};
  StepRule steps = {};
  Halts halts = {};
};

using SectionPlan = Plan<fe::Quad>;
using WedgePlan = Plan<fe::Hexahedron>;

SectionPlan plan(const Simple&);
SectionPlan plan(const Local&);
WedgePlan plan(const Die&);
WedgePlan plan(const Hydrostatic&);
WedgePlan plan(const Triaxial&);
/// The simple press in space.
WedgePlan plan_in_space(const Simple&);

} // namespace platen::press
