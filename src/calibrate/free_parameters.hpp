#pragma once
// What of each law is looked for in a measured curve, where the search starts, and how far it may go.

#include <string>
#include <string_view>
#include <vector>

namespace platen::calibrate {

/// A parameter that is looked for. Stresses are searched by their logarithm, in units of the curve's own
/// stress S = F/(pi R^2 delta/R) at its end, so that one table serves all materials.
struct FreeParameter {
  std::string key;
  bool logarithmic = true;
  bool in_curve_stress = true; ///< bounds and starts are multiples of S
  double low = 0, high = 0;
  std::vector<double> starts;
  bool of_unloading = false; ///< has no part in loading
};

struct FreeLaw {
  std::string_view law;
  std::vector<FreeParameter> parameters;
  std::string_view strength; ///< the key of its strength; empty: it has none
  bool has_unloading = true; ///< its unloading follows from these parameters
  double ratio_most = 1e6;   ///< E over strength that the law's tables reach
  bool scales = true;        ///< F = R^2 f(delta/R): one law serves particles of all sizes
};

/// InvalidInput, with those that can be, for a law that cannot be calibrated.
const FreeLaw& free_law(const std::string& name);
std::vector<std::string> calibrated_laws();

} // namespace platen::calibrate
