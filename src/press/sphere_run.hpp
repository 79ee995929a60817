#pragma once
// A sphere under a plane, as the simple and the local press have it: its state, one step further, its row of
// the curve.

#include "fe/plane_contact.hpp"
#include "press/point_account.hpp"
#include "press/simple.hpp"

#include <vector>

namespace platen::press {

/// Steps of delta_bar. The contact starts as a point, with infinitely many changes of the contact near 0: so
/// a first step, and the largest in relation to delta_bar.
struct StepRule {
  double first, relative_max;
  double growth;          ///< from one to the next
  double largest;         ///< over the case's step_max
  double smallest = 1e-7; ///< below it a step is given up
};

/// Lengths inside are in units of R0, stresses in Pa.
class SphereRun {
 public:
  static constexpr StepRule steps{.first = 1e-4, .relative_max = 0.04, .growth = 1.5, .largest = 1};
  using Result = press::Result;
  using Flow = PointFlow<fe::AxisymmetricSolid>;

  explicit SphereRun(const Case&);
  SphereRun(const Case&, const fe::NewtonSettings&);

  /// Everything that a branch needs to start again from here.
  struct State {
    double delta_bar = 0, step = 0; ///< step: the last one, whose displacement change is extrapolated
    std::vector<double> u, change;
    std::vector<Flow> points;
    CurvePoint row;
  };
  const State& state() const { return now; }
  void restore(const State&);

  /// One step to delta_bar. On success the state is the new one and `row` describes it.
  fe::StepReport advance(double delta_bar);

  const CurvePoint& row() const { return now.row; }
  CurvePoint row(Branch, int branch_id) const;
  double delta_bar() const { return now.delta_bar; }
  std::vector<double> turns() const { return {}; } ///< the plane goes on
  Snapshot snapshot(Branch) const;
  void keep(Result& result, Branch branch) const { result.snapshots.push_back(snapshot(branch)); }
  const fe::PlaneContact& plane() const { return contact; }
  const fe::AxisymmetricSolid& sphere() const { return solid; } ///< holds the evaluation at the last step
  Statistics statistics() const;
  std::vector<std::string> flags() const { return flags_of(solid, now.points); }

 private:
  void account(double delta_bar, int iterations, std::vector<Flow>& points);
  double far_field(const CurvePoint&) const;

  const double radius_m, sigma_ref;
  fe::AxisymmetricSolid solid;
  fe::PlaneContact contact;
  State now;
  Statistics counted;
};

/// The curve of a case before its first point.
Curve begun_curve(const Case&);

/// Where loading halts, ascending: each of both lists, and the end.
std::vector<double> halts(std::vector<double> some, const std::vector<double>& others, double end);

} // namespace platen::press
