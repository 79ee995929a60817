#include "surrogate/tables.hpp"

#include "core/error.hpp"
#include "surrogate/ripples.hpp"
#include "surrogate/said.hpp"

#include <fmt/format.h>

#include <cmath>

namespace platen::surrogate {
namespace {

Table logarithms(const PoolData& data, std::vector<double> Pressed::*list) {
  Table table;
  for (const auto& run : data.runs) {
    table.emplace_back();
    for (const double value : run.*list) table.back().push_back(std::log(value));
  }
  return table;
}

} // namespace

Tables tables_of(const PoolData& data) {
  Tables tables{logarithms(data, &Pressed::F_bar),
                logarithms(data, &Pressed::a_bar),
                {},
                logarithms(data, &Pressed::alpha)};
  if (data.elements < ripple_free_elements)
    for (const auto table : {&Tables::force, &Tables::radius})
      for (auto& row : tables.*table) row = without_ripples(data.knots, row);
  for (std::size_t i = 0; i < data.runs.size(); ++i)
    tables.work.push_back(
        over_force(data.runs[i].returned, data.unload_delta_bar, data.knots, tables.force[i]));
  return tables;
}

std::vector<Both> in_both(const PoolData& fine, const PoolData& coarse) {
  if (fine.engine != coarse.engine || fine.knots != coarse.knots ||
      fine.unload_delta_bar != coarse.unload_delta_bar ||
      fine.runs.front().description.model != coarse.runs.front().description.model)
    throw core::InvalidInput(
        fmt::format("pools {} and {} differ in model, engine, or the overlaps at which their curves "
                    "are given: one cannot be the coarse presses of the other",
                    fine.name, coarse.name));
  const auto same = [](const Pressed& one, const Pressed& other) {
    for (std::size_t k = 0; k < one.description.numbers.size(); ++k)
      if (one.description.numbers[k].value != other.description.numbers[k].value) return false;
    return true;
  };
  std::vector<Both> both;
  for (std::size_t i = 0; i < fine.runs.size(); ++i)
    for (std::size_t j = 0; j < coarse.runs.size(); ++j)
      if (same(fine.runs[i], coarse.runs[j])) both.push_back({i, j});
  constexpr std::size_t fewest = 5;
  if (both.size() < fewest)
    throw core::InvalidInput(
        fmt::format("{} materials were pressed in both pools, {} and {}; {} are wanted at least", both.size(),
                    fine.name, coarse.name, fewest));
  return both;
}

Tables change(const Tables& fine, const Tables& coarse, const std::vector<Both>& both,
              const std::vector<double>& knots) {
  Tables changes;
  for (const auto [i, j] : both) {
    const double scatter = scatter_of(knots, coarse.force[j]);
    for (const auto& [table, over] : {std::pair{&Tables::force, scatter},
                                      {&Tables::radius, 1.0},
                                      {&Tables::work, scatter},
                                      {&Tables::exponent, 1.0}}) {
      auto& row = (changes.*table).emplace_back((fine.*table)[i]);
      for (std::size_t k = 0; k < row.size(); ++k) row[k] = (row[k] - (coarse.*table)[j][k]) / over;
    }
  }
  return changes;
}

} // namespace platen::surrogate
