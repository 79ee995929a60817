#pragma once
// Ward's clusters (1963): those two are joined whose union adds least to the sum of squared distances from
// the centroids, again and again.

#include "study/spread.hpp"

#include <span>
#include <vector>

namespace platen::study {

/// The clusters, each the indices of its points, ascending; sorted by their first. By chains of nearest
/// neighbours, in a time that grows with the square of the number of points. Needs 1 <= clusters <= points.
std::vector<std::vector<std::size_t>> ward(std::span<const CubePoint>, std::size_t clusters);

} // namespace platen::study
