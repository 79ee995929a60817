#pragma once
// A law as numbers, for any DEM code.

#include "fit/law_card.hpp"

#include <string>
#include <vector>

namespace platen::dem {

/// The loading curve, and for every point of it the unloading curve that starts there:
/// F = F_max (1 - rate (overlap_max - overlap))^alpha.
/// CSV; InvalidInput unless the overlaps rise from above 0.
std::string law_table(const fit::LawCard&, const law::Law&, const std::vector<double>& overlaps);

} // namespace platen::dem
