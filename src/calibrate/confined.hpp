#pragma once
// What a particle that was measured between two platens would do in a die and under pressure from all sides
// (Shahin, section 3.6, Figs 3.9 and 3.10), with bands.

#include "calibrate/calibration.hpp"

#include <string>
#include <vector>

namespace platen::calibrate {

/// A value, and 95 % of what the calibration leaves open.
struct Banded {
  double value = 0, low = 0, high = 0;
};

/// One plane of a loading: F/(pi R^2) and a/R over delta/R, to where the law ends.
struct ConfinedCurve {
  std::string loading; ///< simple, die, hydrostatic
  std::vector<double> delta_bar;
  std::vector<Banded> pressure_Pa, a_bar;
};

/// Bands by the covariance C of the parameters: 1.96 sqrt(g^T C g), g the derivatives over their
/// logarithms. They know nothing of how far the law itself is off. InvalidInput for a law that has no
/// loading but simple.
std::vector<ConfinedCurve> confined(const Calibration&);

/// loading,delta_bar,F_over_pi_R2_Pa,…_low,…_high,a_bar,a_bar_low,a_bar_high
std::string confined_csv(const std::vector<ConfinedCurve>&);

} // namespace platen::calibrate
