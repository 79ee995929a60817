#include "surrogate/pool_data.hpp"

#include "core/csv.hpp"
#include "core/error.hpp"
#include "core/number.hpp"
#include "study/pool.hpp"
#include "surrogate/said.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace platen::surrogate {
namespace {

namespace fs = std::filesystem;

/// The name of the folder, also where the path ends in a slash or is ".".
std::string name_of(const fs::path& folder) {
  auto path = fs::weakly_canonical(folder);
  if (path.filename().empty()) path = path.parent_path();
  return path.filename().string();
}

/// Rows of a run (branch_id, delta_bar, F_bar, a_bar) into the loading curve and its branches.
Pressed pressed(const std::vector<std::vector<double>>& rows, std::vector<double>& knots) {
  Pressed run;
  std::map<int, PressedBranch> branches;
  for (const auto& row : rows) {
    const int branch = static_cast<int>(row[0]);
    if (branch == 0) {
      knots.push_back(row[1]);
      run.F_bar.push_back(row[2]);
      run.a_bar.push_back(row[3]);
    } else {
      branches[branch].push_front(row[1], row[2]);
    }
  }
  for (auto& [id, branch] : branches) run.branches.push_back(std::move(branch));
  std::sort(run.branches.begin(), run.branches.end(),
            [](const auto& one, const auto& other) { return one.delta_bar.back() < other.delta_bar.back(); });
  return run;
}

bool ends_early(const PressedBranch& branch) {
  return branch.F_bar.front() > early_end * branch.F_bar.back();
}

} // namespace

double work_along(const PressedBranch& branch) {
  double work = 0;
  for (std::size_t i = 1; i < branch.delta_bar.size(); ++i)
    work += (branch.delta_bar[i] - branch.delta_bar[i - 1]) * (branch.F_bar[i] + branch.F_bar[i - 1]) / 2;
  return work;
}

double returned_of(const PressedBranch& branch, const Description& d) {
  return std::log(work_along(branch) / hertz_overlap(1, d));
}

PoolData read_pool_data(const fs::path& folder, Take take) {
  const auto pool = study::read_pool(folder);
  const auto runs = core::read_csv(folder / "runs.csv");
  const auto engine = core::number_from(pool.engine);
  if (!engine)
    throw core::InvalidInput(
        fmt::format("{}: pressed by engines {}; a surrogate wants one", runs.file, pool.engine));
  PoolData data;
  data.name = name_of(folder);
  data.engine = static_cast<int>(*engine);
  data.asked = pool.study.runs.size();
  const auto refuse = [&](std::size_t i, std::string_view why) {
    throw core::InvalidInput(fmt::format("{}: run {} {}", folder.string(), i + 1, why));
  };
  for (std::size_t i = 0; i < pool.study.runs.size(); ++i) {
    if (pool.states[i] != "done") continue;
    const auto* path = press::by_overlap(pool.study.runs[i].press_case.experiment);
    if (!path || pool.study.runs[i].press_case.experiment.index() != 0)
      refuse(i, "is no simple press; surrogates are made of those alone");
    std::vector<double> knots;
    Pressed run = pressed(pool.curves[i], knots);
    run.pool = data.name;
    run.run = static_cast<int>(i) + 1;
    run.material = pool.study.runs[i].press_case.material;
    run.description = describe(run.material.model);
    if (data.knots.empty()) {
      data.knots = knots;
      data.unload_delta_bar = path->unload_from;
      data.elements = path->elements;
      data.step_max = path->step_max;
    }
    if (data.knots != knots || data.unload_delta_bar != path->unload_from)
      refuse(i, "loads or unloads at other overlaps than the first");
    if (data.runs.size() > 0 && run.description.model != data.runs.front().description.model)
      refuse(i, "is of another model than the first");
    const auto cells = [&](std::string_view name) {
      std::vector<double> values;
      for (const double delta_bar : data.unload_delta_bar) {
        const auto column = runs.column(fmt::format("{}_{}", name, core::number_text(delta_bar)));
        if (!runs.rows[i].cells[column].empty()) values.push_back(runs.number(runs.rows[i], column));
      }
      return values;
    };
    run.alpha = cells("alpha");
    run.beta = cells("beta");
    run.residual = cells("delta_bar_0");
    if (run.alpha.size() < data.unload_delta_bar.size() || run.branches.size() < run.alpha.size() ||
        (take == Take::usable && std::ranges::any_of(run.branches, ends_early))) {
      ++data.not_unloaded;
      continue;
    }
    if (take == Take::usable && grows(8, knots, run.F_bar)) {
      ++data.locked;
      continue;
    }
    for (const auto& branch : run.branches) run.returned.push_back(returned_of(branch, run.description));
    data.runs.push_back(std::move(run));
  }
  constexpr std::size_t fewest = 5;
  if (data.runs.size() < fewest)
    throw core::InvalidInput(fmt::format("{}: {} runs are done; a surrogate wants {} at least",
                                         folder.string(), data.runs.size(), fewest));
  return data;
}

void append(PoolData& data, const PoolData& more) {
  if (data.engine != more.engine || data.elements != more.elements || data.step_max != more.step_max ||
      data.knots != more.knots || data.unload_delta_bar != more.unload_delta_bar ||
      data.runs.front().description.model != more.runs.front().description.model)
    throw core::InvalidInput(fmt::format(
        "pools {} and {} differ in model, engine, mesh, or in where they load to and unload from: "
        "a surrogate cannot be made of both",
        data.name, more.name));
  data.runs.insert(data.runs.end(), more.runs.begin(), more.runs.end());
  data.asked += more.asked;
  data.not_unloaded += more.not_unloaded;
  data.locked += more.locked;
}

} // namespace platen::surrogate
