#include "study/design.hpp"

#include "core/error.hpp"
#include "core/number.hpp"
#include "core/unit.hpp"
#include "study/random.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace platen::study {
namespace {

/// The level at a place in [0, 1) of the range, or of the values.
Level level_at(const Factor& factor, double u) {
  if (!factor.values.empty())
    return factor.values[std::min(static_cast<std::size_t>(u * static_cast<double>(factor.values.size())),
                                  factor.values.size() - 1)];
  if (factor.log) return factor.min * std::pow(factor.max / factor.min, u);
  return factor.min + u * (factor.max - factor.min);
}

Level cell_level(const core::Csv& table, const core::Csv::Row& row, std::size_t column,
                 const Factor& factor) {
  const std::string& cell = row.cells[column];
  if (!factor.names.empty()) {
    if (const auto found = factor.names.find(cell); found != factor.names.end()) return found->second;
    throw core::InvalidInput(fmt::format("{}, line {}, column {}: '{}' is not in the names of factor '{}'",
                                         table.file, row.line, table.columns[column], cell, factor.name));
  }
  if (!core::number_from(cell) && !cell.empty()) return cell;
  const double x = table.number(row, column);
  const double in_si = core::in_units_of(factor.name, table.columns[column]);
  // Twelve digits: the conversion must not show that 1.1e-3 is not 1.1 times 1e-3 in binary.
  return in_si == 1 ? x : *core::number_from(fmt::format("{:.12g}", x * in_si));
}

/// Exchanges two coordinates at a time where that makes the sum of maxpro_term smaller.
void improve(std::vector<CubePoint>& points, const std::vector<std::size_t>& ranges, Random& random) {
  const std::size_t n = points.size();
  std::vector<CubePoint> cube(n, CubePoint(ranges.size()));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t l = 0; l < ranges.size(); ++l) cube[i][l] = points[i][ranges[l]];
  const auto terms = [&](std::size_t a, std::size_t b) {
    double sum = 0;
    for (std::size_t j = 0; j < n; ++j)
      if (j != a && j != b) sum += maxpro_term(cube[a], cube[j]) + maxpro_term(cube[b], cube[j]);
    return sum + maxpro_term(cube[a], cube[b]);
  };
  for (std::size_t trial = 0; trial < 200 * n; ++trial) {
    const std::size_t l = random.below(ranges.size()), a = random.below(n), b = random.below(n);
    if (a == b) continue;
    const double before = terms(a, b);
    std::swap(cube[a][l], cube[b][l]);
    if (terms(a, b) < before) std::swap(points[a][ranges[l]], points[b][ranges[l]]);
    else std::swap(cube[a][l], cube[b][l]);
  }
}

} // namespace

std::vector<Point> factorial(const std::vector<Factor>& factors) {
  std::size_t combinations = 1;
  for (const auto& factor : factors) combinations *= factor.values.size();
  std::vector<Point> points(combinations, Point(factors.size()));
  for (std::size_t i = 0; i < combinations; ++i) {
    std::size_t rest = i;
    for (std::size_t l = factors.size(); l-- > 0; rest /= factors[l].values.size())
      points[i][l] = factors[l].values[rest % factors[l].values.size()];
  }
  return points;
}

std::vector<Point> rows_of(const core::Csv& table, const std::vector<Factor>& factors,
                           const std::map<std::string, std::string>& only) {
  std::vector<std::size_t> columns;
  for (const auto& factor : factors) columns.push_back(table.column(factor.column));
  std::vector<Point> points;
  for (const auto& row : table.rows) {
    if (!std::all_of(only.begin(), only.end(), [&](const auto& wanted) {
          return row.cells[table.column(wanted.first)] == wanted.second;
        }))
      continue;
    Point point;
    for (std::size_t i = 0; i < factors.size(); ++i)
      point.push_back(cell_level(table, row, columns[i], factors[i]));
    points.push_back(std::move(point));
  }
  return points;
}

std::vector<Point> latin_hypercube(const std::vector<Factor>& factors, std::size_t runs, std::uint64_t seed) {
  Random random(seed);
  std::vector<CubePoint> cube(runs, CubePoint(factors.size()));
  std::vector<std::size_t> ranges;
  for (std::size_t l = 0; l < factors.size(); ++l) {
    if (factors[l].values.empty()) ranges.push_back(l);
    std::vector<std::size_t> strata(runs);
    std::iota(strata.begin(), strata.end(), 0);
    random.shuffle(strata);
    for (std::size_t i = 0; i < runs; ++i)
      cube[i][l] = (static_cast<double>(strata[i]) + random.uniform()) / static_cast<double>(runs);
  }
  if (!ranges.empty()) improve(cube, ranges, random);
  std::vector<Point> points;
  for (const auto& place : cube) {
    points.emplace_back();
    for (std::size_t l = 0; l < factors.size(); ++l) points.back().push_back(level_at(factors[l], place[l]));
  }
  return points;
}

std::vector<CubePoint> in_cube(const std::vector<Factor>& factors, const std::vector<Point>& all,
                               const std::vector<Point>& points) {
  std::vector<CubePoint> cube(points.size());
  for (std::size_t l = 0; l < factors.size(); ++l) {
    const auto number = [&](const Point& point) { return std::get_if<double>(&point[l]); };
    if (!std::all_of(all.begin(), all.end(), number) || !std::all_of(points.begin(), points.end(), number))
      continue;
    double low = factors[l].min, high = factors[l].max;
    if (!(low < high)) {
      low = high = *number(all.front());
      for (const auto& point : all)
        low = std::min(low, *number(point)), high = std::max(high, *number(point));
    }
    if (!(low < high)) continue; // one value: no direction
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double x = *number(points[i]);
      cube[i].push_back(factors[l].log ? std::log(x / low) / std::log(high / low) : (x - low) / (high - low));
    }
  }
  return cube;
}

std::vector<std::string> categories(const std::vector<Point>& points) {
  std::vector<std::string> words;
  bool any = false;
  for (const auto& point : points) {
    std::string joined;
    for (const auto& level : point)
      if (const auto* word = std::get_if<std::string>(&level)) joined += *word + " ", any = true;
    words.push_back(joined);
  }
  return any ? words : std::vector<std::string>{};
}

} // namespace platen::study
