#pragma once
// The gate between a measurement and a card: what cannot be is refused, what is hard to believe is written
// beside the result, with the reading that would make sense.

#include <optional>
#include <string>
#include <vector>

namespace platen::fit {

/// What is claimed of a particle; what is not known is left out.
struct Claim {
  std::string name; ///< file or particle, as sentences name it
  double radius_m = 0;
  std::vector<double> delta_m, force_N; ///< loading, in order
  std::optional<double> E_Pa, nu;
  std::optional<double> strength_Pa; ///< uniaxial; yield stress, kappa
  std::optional<double> R2;
  std::vector<std::string_view> on_bound; ///< parameters that ended on their bound
  double valid_to = 0.5;                  ///< delta/R
  bool contact_known = false;             ///< the contact point and the zero of the load cell were fitted
};

struct Doubt {
  bool refuses = false; ///< else it is written beside the result
  std::string sentence;
};

/// Empty where nothing is doubted.
std::vector<Doubt> doubts_about(const Claim&);

/// InvalidInput with all refusing doubts, unless `force`. What remains is to be written into the card.
std::vector<std::string> pass(const std::vector<Doubt>&, bool force);

} // namespace platen::fit
