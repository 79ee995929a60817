#pragma once
// The points of one branch as a fit sees them.

#include "press/curve.hpp"

#include <string_view>
#include <vector>

namespace platen::fit {

/// Points of a branch, ascending in delta_bar, with trapezoid weights: sum(weight f) is the integral of f
/// over delta_bar, from 0 for a loading branch.
struct Samples {
  std::vector<double> delta_bar;
  std::vector<double> F_bar;
  std::vector<double> weight;

  std::size_t size() const { return delta_bar.size(); }
};

/// The loading branch. Throws core::InvalidInput when it has fewer than eight points, is not ascending in
/// delta_bar, not finite, nowhere positive in force, or beyond what can be squared.
Samples loading_samples(const press::Curve&);

/// Throws core::InvalidInput where the largest of the forces is below 1e-60 or above 1e60: sums of squares
/// would be 0 or infinite, and errors no numbers.
void refuse_beyond_squares(const std::vector<double>& F_bar);

/// Trapezoid weights of ascending abscissae; `from` is where the integral starts (at or below the first).
std::vector<double> trapezoid_weights(const std::vector<double>& x, double from);

/// Pool adjacent violators: the growing sequence nearest to y, by at least a hair from one to the next.
std::vector<double> growing(std::vector<double> y, double least_step);

/// How far a law is from a branch.
struct Errors {
  double relative_l2 = 0; ///< (int (F_law - F)^2 d delta_bar)^(1/2) / (int F^2 d delta_bar)^(1/2)
  double e_p = 0; ///< ES (8): max |F_law - F| / F(delta_max), with the absolute value that ES leave out
  double e_a = 0; ///< ES (7): (int (F_law - F)^2 d delta_bar)^(1/2) / int F d delta_bar; not free of
                  ///< delta_max: it scales as delta_max^(-1/2)
};

/// Errors of the values of a law at the samples.
Errors errors(const Samples&, const std::vector<double>& F_bar_law);

/// Coefficient of determination, 1 - int (F_law - F)^2 / int (F - mean F)^2, with the weights of the samples.
double r_squared(const Samples&, const std::vector<double>& F_bar_law);

} // namespace platen::fit
