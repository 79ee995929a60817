#pragma once
// From the numbers that a search moves to the forces of a law.

#include "calibrate/free_parameters.hpp"
#include "calibrate/samples.hpp"
#include "fit/law_card.hpp"
#include "platen/law/knot_curve.hpp"

#include <functional>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace platen::calibrate {

/// A law as its table; or the curve of a material by its formulas, where a table costs more than it saves.
using AnyLaw = std::variant<law::Law, law::KnotCurve>;
/// The law of these values of the free parameters, for a particle of this radius against a plane.
/// InvalidInput where there is no such law.
using Make = std::function<AnyLaw(const law::ParameterTexts&, double radius_m)>;
/// Where the law itself is only expected: laws that are off by one standard deviation, each in a way that has
/// nothing to do with the others'.
using Astray = std::function<std::vector<AnyLaw>(const law::ParameterTexts&, double radius_m)>;

/// What does not change during the search.
struct Task {
  fit::LawCard card; ///< law, variant and the parameters that are given
  Make make;
  Astray astray = {}; ///< none: the law is what it is
  std::vector<FreeParameter> free;
  double curve_stress_Pa = 0; ///< S of the free parameters
  bool scales = true;         ///< one law serves all radii
  std::string strength;       ///< key of the law's strength
  double ratio_most = 1e6;    ///< E over strength beyond which no law is made
};

/// Between what is searched, theta, and what the law is given.
struct Coordinates {
  const Task& task;

  double unit(std::size_t k) const { return task.free[k].in_curve_stress ? task.curve_stress_Pa : 1; }
  double inside(std::size_t k, double value) const;
  double outside(std::size_t k, double theta) const;
  double slope(std::size_t k, double theta) const; ///< d(value)/d(theta)
};

/// Laws that were made: making one takes a hundred times as long as evaluating it, and the particles and
/// derivatives ask for the same few again and again.
class Workshop {
 public:
  explicit Workshop(const Task& task) : task_(task) {}

  /// The radius for which the laws are made that serve these samples.
  double made_for(const Samples& s) const { return task_.scales ? 1.0 : s.radius_m; }

  /// Null where the law has no such material.
  std::shared_ptr<const AnyLaw> law(const double* theta, double radius_m);

  /// predict(); false where the law has no such material, or no finite force.
  bool predicted(const Samples&, const double* theta, double contact_m, std::vector<double>& force,
                 std::vector<double>* stiffness = nullptr);

  /// Task::astray there.
  std::vector<AnyLaw> astray(const double* theta) const;

  const Task& task() const { return task_; }

 private:
  law::ParameterTexts texts_of(const double* theta) const;
  double ratio(const law::ParameterTexts&) const; ///< E over strength; 0 where the law has no such two

  const Task& task_;
  std::vector<std::pair<std::vector<double>, std::shared_ptr<const AnyLaw>>> made_;
  std::size_t next_ = 0;
};

} // namespace platen::calibrate
