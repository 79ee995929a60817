#pragma once
// The least squares behind a calibration: parameters of the law that all particles share, and of each
// particle its contact point and the zero of its load cell.

#include "calibrate/state.hpp"
#include "calibrate/workshop.hpp"

#include <string>
#include <vector>

namespace platen::calibrate {

/// What is found for one particle.
struct Own {
  double contact_m = 0, contact_error_m = 0; ///< travel
  double baseline_N = 0,
         drift_N = 0; ///< zero of the load cell at the first row, and what it gains to the last
  bool baseline_fitted = false, drift_fitted = false; ///< false, and 0, where no row out of contact shows it
  std::vector<double> force_N; ///< of the law at the samples, without the zero of the load cell
};

struct Solution {
  std::vector<double> values, errors; ///< of the free parameters, standard errors
  std::vector<double> noise_errors;   ///< the same without what is not known of the law itself
  std::vector<bool> on_bound, without_effect;
  std::vector<std::vector<double>> correlations;
  std::vector<Own> own;
  double reduced_chi_squared = 0;
  bool converged = false;
  std::vector<Samples> samples; ///< as they were weighed at last
  State state;                  ///< there
};

/// Weighted by what the noise of force and travel lets expect: the stiff rows of an unloading say little of
/// the force and much of the travel. Started from `start`, or where that is empty from the best of a grid of
/// starts. Throws core::Interrupted.
Solution search(const Task&, std::vector<Samples>, const std::vector<double>& start = {});

/// The same from where a profile went lower; weights stay.
Solution search_on(const Task&, const Solution&, State from);

/// What a set of parameters gives: the deviance -2 ln(L/L_max) beside the solution, contact points and zeros
/// of load cells fitted anew; and what belongs to each particle.
struct Trial {
  double deviance = std::numeric_limits<double>::infinity();
  std::vector<Own> own; ///< empty: the law has no such material
};
Trial trial(const Task&, const Solution&, const std::vector<double>& values);

/// Standard errors, correlations and the law at a minimum. What is not known of the law (Task::astray) adds
/// to the covariance: each way astray shifts the minimum by (J^T J)^-1 J^T dF/sigma.
Solution solution_of(Workshop&, std::vector<Samples>, State);

} // namespace platen::calibrate
