#pragma once
// Where force begins on a curve that knows neither its contact point nor the zero of its load cell.

#include <cstddef>
#include <vector>

namespace platen::fit {

struct Onset {
  double x = 0;                ///< where force begins
  double uncertainty = 0;      ///< by noise, and by how far up the foot is taken
  double baseline = 0;         ///< force before it; 0 where no row shows it
  std::size_t rows_before = 0; ///< that show the baseline
};

/// F = baseline + A max(x - x_0, 0)^p by least squares on the foot of a loading curve, up to 0.15 and to
/// 0.35 of its largest force: x_0 and p searched (p from 0.8 to `p_most`; Hertz 3/2, plastic 1 and more), the
/// rest is linear. `x` and `F` of loading alone, in order, at least 2 rows.
Onset find_onset(const std::vector<double>& x, const std::vector<double>& F, double force_noise,
                 double p_most = 1.6);

} // namespace platen::fit
