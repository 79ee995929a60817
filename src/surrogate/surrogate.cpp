#include "surrogate/surrogate.hpp"

#include "core/error.hpp"
#include "fit/unloading.hpp"
#include "press/press.hpp"
#include "study/grid.hpp"
#include "surrogate/said.hpp"
#include "surrogate/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace platen::surrogate {
namespace {

void add_ranges(Surrogate& s, const PoolData& data) {
  const auto& first = data.runs.front().description;
  for (std::size_t k = 0; k < first.numbers.size(); ++k) {
    Range range{first.numbers[k].key, INFINITY, -INFINITY};
    for (const auto& run : data.runs) {
      range.low = std::min(range.low, run.description.numbers[k].value);
      range.high = std::max(range.high, run.description.numbers[k].value);
    }
    s.ranges.push_back(range);
  }
  for (std::size_t k = 0; k < first.coordinates.size(); ++k) {
    double low = INFINITY, high = -INFINITY;
    for (const auto& run : data.runs) {
      low = std::min(low, run.description.coordinates[k]);
      high = std::max(high, run.description.coordinates[k]);
    }
    s.low.push_back(low);
    s.high.push_back(high);
  }
}

Layer fit_layer(const Surrogate& s, const Tables& tables, const std::vector<const Pressed*>& runs) {
  Inputs inputs;
  for (const auto* run : runs) {
    const auto input = input_of(s, run->description.coordinates);
    inputs.dimensions = input.size();
    inputs.values.insert(inputs.values.end(), input.begin(), input.end());
  }
  Layer layer(std::move(inputs));
  for (const auto& [table, components] : {std::pair{&tables.force, &layer.force},
                                          {&tables.radius, &layer.radius},
                                          {&tables.work, &layer.work},
                                          {&tables.exponent, &layer.exponent}}) {
    Reduced reduced = reduce(*table);
    *components = std::move(reduced.components);
    for (const auto& scores : reduced.scores)
      components->processes.push_back(fit_process(layer.inputs, scores));
  }
  return layer;
}

std::vector<const Pressed*> all(const PoolData& data) {
  std::vector<const Pressed*> runs;
  for (const auto& run : data.runs) runs.push_back(&run);
  return runs;
}

Layer fit_change(const Surrogate& s, const PoolData& fine, const PoolData& coarse) {
  const auto both = in_both(fine, coarse);
  std::vector<const Pressed*> runs;
  for (const auto& one : both) runs.push_back(&fine.runs[one.fine]);
  return fit_layer(s, change(tables_of(fine), tables_of(coarse), both, s.knots), runs);
}

/// As a pool's (pool_data.hpp).
bool ends_early(const press::Curve& curve, const fit::UnloadingFit& fit) {
  double last = 0;
  for (const auto& point : curve.points)
    if (point.branch_id == fit.branch_id) last = point.F_bar;
  return last > early_end * fit.F_bar_max;
}

} // namespace

ReadPools read_pools(const std::filesystem::path& fine, const std::vector<std::string>& with,
                     const std::string& coarse) {
  ReadPools pools{read_pool_data(fine), {}};
  for (const auto& pool : with) append(pools.fine, read_pool_data(pool));
  if (!coarse.empty()) pools.coarse = read_pool_data(coarse);
  return pools;
}

Surrogate fit_surrogate(const Pools& pools) {
  const auto& [fine, coarse] = pools;
  Surrogate s;
  const PoolData& first = coarse ? *coarse : fine;
  s.pool = fine.name;
  s.model = fine.runs.front().description.model;
  s.engine = fine.engine;
  s.asked = static_cast<int>(fine.asked);
  s.knots = fine.knots;
  s.unload_delta_bar = fine.unload_delta_bar;
  add_ranges(s, first);
  for (const auto& run : first.runs) {
    s.runs.push_back((coarse ? fine.name : run.pool) + "-" + std::to_string(run.run));
    s.numbers.emplace_back();
    for (const auto& number : run.description.numbers) s.numbers.back().push_back(number.value);
  }
  s.layers.push_back(fit_layer(s, tables_of(first), all(first)));
  if (coarse) s.layers.push_back(fit_change(s, fine, *coarse));
  const auto errors = leave_out(s, pools);
  s.fine = static_cast<int>(errors.size());
  // A layer of changes has few materials for its coordinates and is fitted to them too closely.
  s.band = band_of(coarse ? leave_out(s, pools, Left::anew) : errors);
  s.left_out = summary_of(errors, s.band);
  if (!coarse) return s;
  s.guide = Guide{coarse->elements, coarse->step_max, band_of(leave_out_guided(s, pools, Left::anew)), {}};
  s.guide->left_out = summary_of(leave_out_guided(s, pools), s.guide->band);
  return s;
}

CoarsePress press_guide(const Surrogate& s, const material::Material& material) {
  press::Simple simple;
  simple.delta_bar_max = s.knots.back();
  simple.unload_from = s.unload_delta_bar;
  simple.elements = s.guide->elements;
  simple.step_max = s.guide->step_max;
  const auto result = press::press({material, 1e-3, simple});
  if (result.out_of_memory) throw core::IoError(*result.failure);
  CoarsePress said;
  std::map<int, PressedBranch> branches;
  for (const auto& point : study::on_grid(result.curve, 0.01)) { // as the pools have it
    if (point.branch_id != 0) branches[point.branch_id].push_front(point.delta_bar, point.z.F_bar);
    else if (said.F_bar.size() < s.knots.size() &&
             std::abs(point.delta_bar - s.knots[said.F_bar.size()]) <= 1e-9) {
      said.F_bar.push_back(point.z.F_bar);
      said.a_bar.push_back(point.z.a_bar);
    }
  }
  if (said.F_bar.size() < s.knots.size())
    throw core::ConvergenceError(
        fmt::format("{}: the press that guides the prediction did not get to delta/R0 = {:.4g}; "
                    "`platen derive` presses on more elements",
                    material.name, s.knots.back()),
        0, 0, 0);
  const auto fits = fit::fit_unloading(result.curve).fits;
  const bool all = fits.size() == s.unload_delta_bar.size() &&
                   std::ranges::none_of(fits, [&](const auto& one) { return ends_early(result.curve, one); });
  const auto description = describe(material.model);
  for (const auto& one : fits)
    if (all) {
      said.alpha.push_back(one.alpha);
      said.returned.push_back(returned_of(branches.at(one.branch_id), description));
    }
  return said;
}

} // namespace platen::surrogate
