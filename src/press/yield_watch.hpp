#pragma once
// What the local press looks for while it loads: first yield on the axis and at the contact edge, and the
// load at which the plastic zone breaks through to the free surface.

#include "press/result.hpp"
#include "press/step.hpp"

#include <utility>

namespace platen::press {

class YieldWatch {
 public:
  using Stepper = press::Stepper<fe::Quad>;
  using State = press::State<fe::Quad>;

  explicit YieldWatch(const Local& experiment) : first_contact_bar(experiment.first_contact_bar) {}
  /// After each step of loading.
  void look(const Stepper&, const State&);
  void report(Result&) const;

 private:
  void learn(const fe::Solid<fe::Quad>&);
  void look_for_onset(const Stepper&, const State&);
  void look_for_break_through(const Stepper&, const State&);
  double joining_strain(const std::vector<double>& plastic_strain, double a) const;

  struct Candidate { ///< for an onset: of the last step before it
    std::optional<Onset> last;
    bool met = false;
  };
  static void extend(Candidate&, double force_N, std::array<double, 2> place, double reserve);
  double edge_reserve(const Stepper&, const State&) const;

  double first_contact_bar;
  std::vector<std::array<double, 2>> places;     ///< of the Gauss points, R0: r, depth below the pole
  std::vector<std::vector<int>> neighbours;      ///< elements that share an edge
  std::vector<std::pair<int, double>> at_sphere; ///< elements at the sphere, their polar angle
  Candidate axis, edge;
  BreakThrough joined{0, 0}; ///< of the last step
  std::vector<BreakThrough> broken;
};

} // namespace platen::press
