#pragma once
// The rows of Wang et al. by section.

#include "reproduce/data.hpp"
#include "reproduce/row.hpp"

#include <vector>

namespace platen::reproduce {

std::vector<Row> wang_coefficient_rows(const Data&); ///< section 4: a, b, m, n

} // namespace platen::reproduce
