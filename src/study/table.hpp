#pragma once
// A study as tables: inputs, fitted parameters with errors, cost; and its curves. Laws are fitted to the kept
// curves here, so that a fit is done again without a press.

#include "study/card.hpp"
#include "study/sheet.hpp"
#include "study/store.hpp"

#include <string>
#include <vector>

namespace platen::study {

/// Names that [fit] laws may have.
std::vector<std::string> fitted_laws();

struct Found {
  std::string key;
  Store::State state;
};
/// Of each run of the study, its content verified.
std::vector<Found> find_runs(const Study&, const Store&);

/// A sentence where no run is done; empty otherwise.
std::string nothing_done(const Store&, const std::vector<Found>&);
/// A sentence about the runs that are damaged; empty where none is.
std::string damage(const Store&, const std::vector<Found>&);

/// The inputs of each run, and the derived quantities of its case.
Sheet design_sheet(const Study&);

/// One row a run, in the order of the design, the same for the same runs but for the columns cpu_s and
/// wall_s, which are the last.
Sheet runs_sheet(const Study&, const Store&, const std::vector<Found>&, std::string_view variant);

/// The curves of the runs that are done, on a common grid (grid.hpp), in six digits; `run` is the number of
/// the row in the other sheet, from 1.
Sheet curves_sheet(const Study&, const Store&, const std::vector<Found>&, double step);

} // namespace platen::study
