#include "study/pool.hpp"

#include "core/csv.hpp"
#include "core/error.hpp"
#include "core/number.hpp"
#include "core/version.hpp"
#include "study/derived.hpp"
#include "study/random.hpp"
#include "study/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace platen::study {
namespace {

namespace fs = std::filesystem;
using Rows = std::vector<std::vector<double>>;

/// A folder that goes with the object.
class Scratch {
 public:
  Scratch() {
    std::string name = (fs::temp_directory_path() / "platen-XXXXXX").string();
    if (!::mkdtemp(name.data()))
      throw core::IoError(fmt::format("{}: no folder can be made there", fs::temp_directory_path().string()));
    path_ = name;
  }
  ~Scratch() {
    std::error_code error;
    fs::remove_all(path_, error);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// Rows of each run: branch_id, then the numbers from delta_bar on. Empty cells are zero.
std::vector<Rows> curves_of(const core::Csv& csv, std::size_t runs) {
  std::vector<Rows> curves(runs);
  const auto run = csv.column("run"), branch = csv.column("branch_id"), first = csv.column("delta_bar");
  for (const auto& row : csv.rows) {
    const double number = csv.number(row, run);
    if (!(number >= 1 && number <= static_cast<double>(runs)))
      throw core::InvalidInput(fmt::format("{}, line {}: run {} is not one of the {} of the study", csv.file,
                                           row.line, row.cells[run], runs));
    std::vector<double> numbers = {csv.number(row, branch)};
    for (std::size_t i = first; i < csv.columns.size(); ++i)
      numbers.push_back(row.cells[i].empty() ? 0 : csv.number(row, i));
    curves[static_cast<std::size_t>(number) - 1].push_back(std::move(numbers));
  }
  return curves;
}

/// Two steps on, so that the curve up to there is interpolated as that of the whole press: a step is at most
/// 4 % of the overlap, and at most step_max.
double behind(double delta_bar, const press::ByOverlap& e) {
  return delta_bar + std::min(0.09 * delta_bar, 2.02 * e.step_max);
}

/// The rows of a loading branch up to an overlap.
Rows up_to(const Rows& rows, double delta_bar) {
  Rows result;
  for (const auto& row : rows)
    if (row[0] == 0 && row[1] <= delta_bar * (1 + 1e-9)) result.push_back(row);
  return result;
}

/// The largest difference over the largest value, column by column.
Comparison compare(std::size_t run, const Rows& pool, const Rows& again) {
  Comparison result{run, {}, {}};
  if (again.empty() || pool.size() != again.size()) {
    result.reason = fmt::format("{} rows pressed, {} in the pool", again.size(), pool.size());
    return result;
  }
  double largest = 0;
  for (std::size_t column = 0; column < again[0].size(); ++column) {
    double scale = 0, difference = 0;
    for (std::size_t i = 0; i < again.size(); ++i) {
      if (pool[i].size() != again[i].size()) {
        result.reason = "the pool has other columns";
        return result;
      }
      scale = std::max(scale, std::abs(pool[i][column]));
      difference = std::max(difference, std::abs(pool[i][column] - again[i][column]));
    }
    if (difference > 0) largest = std::max(largest, difference / scale);
  }
  result.difference = largest;
  return result;
}

} // namespace

Pool read_pool(const fs::path& folder) {
  const auto runs = core::read_csv(folder / "runs.csv"), curves = core::read_csv(folder / "curves.csv");
  Pool pool{folder, read_study((folder / "study.toml").string()), runs.note("engine"), 0, {}, {}, {}};
  const auto key = runs.column("key"), state = runs.column("state"), cpu_s = runs.column("cpu_s");
  if (runs.rows.size() != pool.study.runs.size())
    throw core::InvalidInput(fmt::format("{}: {} runs, where the study has {}; export it again", runs.file,
                                         runs.rows.size(), pool.study.runs.size()));
  for (std::size_t i = 0; i < runs.rows.size(); ++i) {
    const auto& row = runs.rows[i];
    // One engine: the keys say whether these are the runs of the study.
    if (const auto number = core::number_from(pool.engine);
        number && row.cells[key] != key_of(pool.study.runs[i].press_case, static_cast<int>(*number)))
      throw core::InvalidInput(fmt::format("{}, line {}: the key is not that of run {} of the study: the "
                                           "study, or a card that it names, changed; "
                                           "run and export it again",
                                           runs.file, row.line, i + 1));
    pool.states.push_back(row.cells[state]);
    pool.cpu_s.push_back(row.cells[cpu_s].empty() ? 0 : runs.number(row, cpu_s));
  }
  pool.step = curves.number_note("step");
  pool.curves = curves_of(curves, pool.study.runs.size());
  return pool;
}

double tolerance(const Pool& pool) { return pool.engine == std::to_string(core::engine) ? 1e-3 : 0.03; }

std::vector<std::size_t> two_cheap(const Pool& pool) {
  std::vector<std::size_t> done;
  for (std::size_t i = 0; i < pool.states.size(); ++i)
    if (pool.states[i] == "done") done.push_back(i);
  const auto lambda = [&](std::size_t i) { return lambda_of(pool.study.runs[i].press_case); };
  std::stable_sort(done.begin(), done.end(), [&](auto i, auto j) { return lambda(i) < lambda(j); });
  const auto middle = done.begin() + static_cast<std::ptrdiff_t>(done.size() / 2);
  std::vector<std::size_t> chosen;
  for (const auto& [first, last] : {std::pair{done.begin(), middle}, {middle, done.end()}})
    if (first != last)
      chosen.push_back(
          *std::min_element(first, last, [&](auto i, auto j) { return pool.cpu_s[i] < pool.cpu_s[j]; }));
  return chosen;
}

std::vector<std::size_t> sample(const Pool& pool, double share, std::uint64_t seed) {
  std::vector<std::size_t> there;
  for (std::size_t i = 0; i < pool.states.size(); ++i)
    if (pool.states[i] != "missing") there.push_back(i);
  Random random(seed);
  random.shuffle(there);
  const auto wanted = static_cast<std::size_t>(std::ceil(share * static_cast<double>(there.size()) - 1e-9));
  there.resize(std::min(std::max<std::size_t>(wanted, 1), there.size()));
  std::sort(there.begin(), there.end());
  return there;
}

std::vector<Comparison> recompute(const Pool& pool, const std::vector<std::size_t>& runs, double until,
                                  int workers, const std::function<void(const Tally&)>& show) {
  const Scratch scratch;
  Study again = pool.study;
  again.runs.clear();
  std::vector<bool> whole;
  for (const auto i : runs) {
    again.runs.push_back(pool.study.runs[i]);
    auto& run = again.runs.back();
    const press::ByOverlap* path = press::by_overlap(run.press_case.experiment); // others cannot end early
    whole.push_back(!(until > 0 && path && until < path->delta_bar_max));
    if (!whole.back()) run.stop_at = behind(until, *path);
  }
  Store store(scratch.path(), again.name);
  store.open_for_writing(OldRuns::ask);
  work(again, store, workers, show);
  const auto found = find_runs(again, store);
  auto curves = curves_of(core::parse_csv(csv_text(curves_sheet(again, store, found, pool.step)), "curves"),
                          again.runs.size());
  // Where no die was chosen there are no columns of walls; in the pool they are empty for these runs.
  for (std::size_t i = 0; i < runs.size(); ++i)
    for (auto& row : curves[i])
      if (const auto& rows = pool.curves[runs[i]]; !rows.empty() && row.size() < rows[0].size())
        row.resize(rows[0].size(), 0);
  std::vector<Comparison> comparisons;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto& [key, state] = found[i];
    const bool failed = state == Store::State::failed, pool_failed = pool.states[runs[i]] == "failed";
    if (failed == pool_failed && failed) comparisons.push_back({runs[i], 0.0, {}});
    else if (failed) comparisons.push_back({runs[i], {}, "the press failed: " + store.failure(key)});
    else if (pool_failed && whole[i])
      comparisons.push_back({runs[i], {}, "the press failed in the pool alone"});
    else if (whole[i]) comparisons.push_back(compare(runs[i], pool.curves[runs[i]], curves[i]));
    else comparisons.push_back(compare(runs[i], up_to(pool.curves[runs[i]], until), up_to(curves[i], until)));
  }
  return comparisons;
}

} // namespace platen::study
