#include "study/filling.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace platen::study {
namespace {

/// The points of `other` with the factors in the order of `s`.
std::vector<Point> reordered(const Study& other, const Study& s) {
  std::vector<std::size_t> order;
  for (const auto& factor : s.factors) {
    const auto found = std::find_if(other.factors.begin(), other.factors.end(),
                                    [&](const Factor& f) { return f.name == factor.name; });
    if (found == other.factors.end())
      throw core::InvalidInput(
          fmt::format("{}: there is no factor '{}', which {} has; designs are compared over "
                      "the same factors",
                      other.file, factor.name, s.file));
    order.push_back(static_cast<std::size_t>(found - other.factors.begin()));
  }
  std::vector<Point> points;
  for (const auto& run : other.runs) {
    points.emplace_back();
    for (const auto i : order) points.back().push_back(run.inputs[i]);
  }
  return points;
}

Spread spread_in(const Study& s, const std::vector<Point>& points) {
  return spread(in_cube(s.factors, points_of(s), points), categories(points));
}

} // namespace

Spread spread_of(const Study& s) { return spread_in(s, points_of(s)); }
Spread spread_of(const Study& other, const Study& s) { return spread_in(s, reordered(other, s)); }

} // namespace platen::study
