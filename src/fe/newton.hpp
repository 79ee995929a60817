#pragma once
// Newton's method for the equilibrium of a solid in contact.

#include "fe/axisymmetric.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

namespace platen::fe {

struct NewtonSettings {
  double relative_residual_tolerance = 1e-5; ///< of the free unknowns, relative to the reactions
  int iterations_max = 25;
};

/// One equilibrium.
struct StepReport {
  bool converged = false;
  int iterations = 0;
  std::string why;               ///< it did not converge
  std::vector<double> residuals; ///< relative, one an iterate
  bool contact_changed = false;  ///< of any contact point, after the first iterate
  bool zone_changed = false;     ///< of any Gauss point, after the first iterate

  /// Converged in two iterations or more without a change of contact or zone: no kink was crossed.
  bool smooth() const { return converged && !contact_changed && !zone_changed && residuals.size() >= 3; }
  /// Smooth, and r_2/r_0 <= 100 (r_1/r_0)^2, down to r_2 = 1e-12.
  bool quadratic() const {
    if (!smooth()) return false;
    const double first = residuals[1] / residuals[0];
    return residuals[2] <= std::max(100 * first * first * residuals[0], 1e-12);
  }
};

/// What Newton asks of a solid and what it touches.
class Equilibrium {
 public:
  virtual ~Equilibrium() = default;

  struct Residual {
    std::span<const double> force; ///< per unknown; 0 where it is fixed
    double relative = 0;
    std::vector<char> touching; ///< per contact point
  };
  virtual Evaluation evaluate(const std::vector<double>& x, Residual&) = 0;
  /// Factorises the tangent at the last evaluation. False where it is singular.
  virtual bool linearise(const Residual&) = 0;
  /// Replaces the right-hand side by the solution. False where the tangent is singular.
  virtual bool solve_linear(std::span<double> rhs_to_solution) = 0;
  virtual std::span<const material::PointUpdate> updates() const = 0;
};

/// Reactions so small that the rounding of the strains would be a larger residual count as larger.
double relative_residual(const material::Model&, const NewtonSettings&, double free_square,
                         double reaction_square);

/// Solves from the guess in x, with a line search where the work of the residual does not fall. Where the
/// report says that it did not converge, x is unspecified.
StepReport newton(Equilibrium&, const NewtonSettings&, std::vector<double>& x);

} // namespace platen::fe
