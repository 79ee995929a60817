#pragma once
// The hardening of a von Mises material in another form: Ludwik's as Hollomon's, any as a table, and so on.

#include "material/models.hpp"

#include <string>

namespace platen::fit {

/// From here to there, equivalent plastic strain eps_p.
struct StrainRange {
  double from = 0, to = 1;
};

struct RewrittenHardening {
  material::VonMises material;
  double relative_rms = 0; ///< sqrt(mean (sigma' - sigma)^2/mean sigma^2) over the range
  double worst = 0;        ///< largest |sigma'/sigma - 1| on the range
  double worst_at = 0;     ///< eps_p there
};

/// The material with its hardening of the kind `kind`, as cards name it (none, exponential, hollomon, ludwik,
/// table), E and nu kept: the least integral of (sigma' - sigma)^2 over eps_p, sigma in Pa. A table goes
/// through 100 points, closer together where the range begins. InvalidInput: no such kind, a range that is
/// none, or no law of this kind follows the stress: its exponent or strength ends on a bound.
RewrittenHardening rewrite_hardening(const material::VonMises&, const std::string& kind, StrainRange);

} // namespace platen::fit
