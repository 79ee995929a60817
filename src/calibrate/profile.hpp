#pragma once
// Profile likelihood: how the deviance grows as one parameter is held aside of its best value and all others
// follow, contact points included (Venzon & Moolgavkar 1988; Raue et al. 2009). Where a parameter is weakly
// determined, its interval is far from symmetric, or has no end.

#include "calibrate/search.hpp"

#include <optional>
#include <string>
#include <vector>

namespace platen::calibrate {

/// A parameter held at a value, and how much worse the fit is then.
struct ProfilePoint {
  double value = 0, deviance = 0; ///< deviance: -2 ln(L/L_max), the chi-squared it adds
};

struct Profile {
  std::vector<ProfilePoint> points; ///< ascending; the best value among them
  /// Of 95 %: where the deviance is 3.841, the quantile of chi-squared of one degree of freedom. An end that
  /// is open lies at the bound of the search, or where the law ends.
  double low = 0, high = 0;
  bool open_low = false, open_high = false;
  std::optional<State> better = {}; ///< on the way: the search had ended beside the least deviation
};
constexpr double deviance_95 = 3.841459;

/// "1.9e9 to 2.3e9", "above 1.9e9": the interval of 95 %.
std::string words_of(const Profile&);

/// Of the k-th free parameter. With what is not known of the law itself deviances shrink as the standard
/// error grows. `drawn`: with points between, for a picture. Throws core::Interrupted.
Profile profile(const Task&, const Solution&, std::size_t k, bool drawn = false);

} // namespace platen::calibrate
