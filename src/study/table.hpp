#pragma once
// A study as one table: inputs, fitted parameters with errors, cost. Laws are fitted to the kept curves here,
// so that a fit is done again without a press.

#include "study/card.hpp"
#include "study/store.hpp"

#include <string>

namespace platen::study {

/// One row a run, in the order of the design, the same bytes for the same runs but for the columns cpu_s and
/// wall_s, which are the last.
std::string runs_csv(const Study&, const Store&, std::string_view variant);

} // namespace platen::study
