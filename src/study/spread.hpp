#pragma once
// How well points fill the unit cube.

#include <span>
#include <string>
#include <vector>

namespace platen::study {

/// Coordinates in [0, 1].
using CubePoint = std::vector<double>;

/// 1/prod_l (a_l - b_l)^2: what a pair adds to the MaxPro criterion. Infinite where the two share a
/// coordinate: one of them then tells nothing new about the other factors alone.
double maxpro_term(const CubePoint& a, const CubePoint& b);

struct Spread {
  double min_distance = 0; ///< Euclidean, between any two points
  /// Between two points of one category; 0 where no category has two.
  double min_distance_within = 0;
  /// (mean over all pairs of maxpro_term)^(1/p), p coordinates (Joseph, Gul & Ba 2015, eq. 5): small is good.
  double maxpro = 0;
};

/// `categories`: of each point, or none. All zero for fewer than two points.
Spread spread(std::span<const CubePoint>, std::span<const std::string> categories = {});

} // namespace platen::study
