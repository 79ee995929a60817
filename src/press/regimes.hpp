#pragma once
// The regimes that a plastic particle passes through as it is pressed (SH section 2.3, Fig. 2.3): elastic,
// elastic-plastic, plastic, low compressibility, elastic volumetric. Where one ends is read from the curve:
// from its energies and from the mean pressure on the planes along z.

#include "press/curve.hpp"

#include <optional>
#include <string>
#include <vector>

namespace platen::press {

struct Regimes {
  // Overlaps delta/R0 at which a regime begins; empty where the curve shows no such regime.
  std::optional<double> elastic_plastic; ///< first yield
  std::optional<double> plastic;         ///< flow no longer contained
  std::optional<double> low_compressibility;
  std::optional<double> elastic_volumetric;
  bool yields_in_first_row = false; ///< elastic_plastic is a bound then
  /// Stored share of the rate of work at the end of loading; empty where there is no work.
  std::optional<double> stored_share_at_end;
};

/// A boundary by name, with the criterion that found it.
struct RegimeBoundary {
  const char* key;  ///< in summary.json
  const char* name; ///< of the regime that begins
  const char* criterion;
  std::optional<double> Regimes::*delta_bar;
};

/// In the order in which they are passed.
const std::vector<RegimeBoundary>& regime_boundaries();

/// Dissipated over work at first yield.
inline constexpr double yield_share = 1e-3;
/// By how much smoothed pressure must fall from the maximum to the minimum, and rise after it.
inline constexpr double least_turn = 0.05;

/// Of the loading branch. Node-wise contact leaves scallops of 2 to 5 % in the mean pressure, so it is
/// smoothed by quadratics in least squares over windows of half-width delta/2, at most a seventh of the range
/// pressed. Nothing but empty boundaries where the branch has fewer than eight points.
Regimes regimes(const Curve&);

/// A line for each regime that begins, and one for each that is not reached.
std::string regimes_words(const Regimes&);

} // namespace platen::press
