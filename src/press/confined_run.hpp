#pragma once
// A wedge of a sphere between planes, as the confined presses have it.

#include "fe/wedge_contact.hpp"
#include "press/confined.hpp"
#include "press/point_account.hpp"
#include "press/sphere_run.hpp"

#include <functional>

namespace platen::press {

/// How the planes move with the time of the press. Die and hydrostatic presses count it in delta_bar.
struct Motion {
  fe::Wedge wedge = fe::Wedge::octant;
  std::array<bool, 3> present{};                            ///< planes along x, y, z
  std::function<std::array<double, 3>(double)> overlaps_at; ///< delta/R0 along x, y, z
  std::vector<double> turns;                                ///< times at which it changes its direction
  std::vector<char> retreats;                               ///< whether the planes move apart up to a turn
  double end = 0;
};
Motion motion_of(const Case&);

/// Lengths inside are in units of R0, stresses in Pa.
class ConfinedRun {
 public:
  using Result = ConfinedResult;
  using Flow = PointFlow<fe::HexahedralSolid>;
  static constexpr StepRule steps{.first = 5e-4, .relative_max = 0.1, .growth = 1.5, .largest = 2};

  explicit ConfinedRun(const Case&);

  struct State {
    double time = 0, step = 0; ///< step: the last one, whose displacement change is extrapolated
    std::vector<double> u, change;
    std::vector<Flow> points;
    CurvePoint row;
  };
  const State& state() const { return now; }
  void restore(const State&);

  /// One step to a time. On success the state is the new one and `row` describes it.
  fe::StepReport advance(double time);

  const CurvePoint& row() const { return now.row; }
  CurvePoint row(Branch, int branch_id) const;
  double delta_bar() const { return now.time; } ///< of a triaxial press the way gone, path_length()
  const std::vector<double>& turns() const { return motion.turns; }
  void keep(Result&, Branch) const;
  Statistics statistics() const;
  std::vector<std::string> flags() const;

 private:
  void account(const std::array<double, 3>& overlaps, int iterations, std::vector<Flow>& points);

  const double radius_m, sigma_ref;
  const Motion motion;
  const fe::WedgeMesh mesh;
  fe::HexahedralSolid solid;
  std::array<int, 3> plane_of; ///< along x, y, z; images count as the plane they are of; -1: none
  fe::WedgeContact contact;
  const double halves; ///< wedges in half a sphere
  State now;
  Statistics counted;
};

} // namespace platen::press
