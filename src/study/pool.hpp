#pragma once
// Data pools: a folder with a study and what it gave: study.toml, runs.csv, curves.csv (`platen study
// export`). A pool is checked by pressing some of its runs again.

#include "study/card.hpp"
#include "study/work.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace platen::study {

struct Pool {
  std::filesystem::path folder;
  Study study;
  std::string engine;              ///< that pressed it; several where it was continued with another
  double step = 0;                 ///< of the grid of its curves
  std::vector<std::string> states; ///< of the runs: done, failed, missing
  std::vector<double> cpu_s;
  std::vector<std::vector<std::vector<double>>>
      curves; ///< of each run: rows of branch_id, delta_bar, F_bar, …
};

/// InvalidInput where a file is missing, or does not belong to the study.
Pool read_pool(const std::filesystem::path& folder);

/// Runs of the pool, from 0: of the half with the smaller lambda = E/((1 - nu^2) sigma_ref) and of the other
/// half the run that took least time (the latter yields early).
std::vector<std::size_t> two_cheap(const Pool&);
/// A share of all at random, at least one.
std::vector<std::size_t> sample(const Pool&, double share, std::uint64_t seed);

struct Comparison {
  std::size_t run = 0; ///< from 0
  /// The largest difference of any column at any row, over the largest value of that column in the run; none
  /// where the two do not have the same rows.
  std::optional<double> difference;
  std::string reason; ///< why not
};

/// Presses the runs again in `workers` processes and compares. `until`: simple, die and hydrostatic presses
/// end at this delta/R0, without unloading; 0: they are pressed to their ends.
std::vector<Comparison> recompute(const Pool&, const std::vector<std::size_t>& runs, double until,
                                  int workers, const std::function<void(const Tally&)>& show);

/// What a run may differ by. The same machine and compiler give the same curve to its six digits; others
/// change in which iteration a step is found good enough, and thereby the steps: 1e-3. Of the pool of another
/// engine no more is asked than that both are right, within the error of their contact radii: 0.03.
double tolerance(const Pool&);

} // namespace platen::study
