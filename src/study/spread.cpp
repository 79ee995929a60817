#include "study/spread.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace platen::study {

double maxpro_term(const CubePoint& a, const CubePoint& b) {
  double product = 1;
  for (std::size_t l = 0; l < a.size(); ++l) product *= (a[l] - b[l]) * (a[l] - b[l]);
  return 1 / product;
}

Spread spread(std::span<const CubePoint> points, std::span<const std::string> categories) {
  if (points.size() < 2 || points[0].empty()) return {};
  constexpr double none = std::numeric_limits<double>::infinity();
  double closest = none, closest_within = none, sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      double square = 0;
      for (std::size_t l = 0; l < points[i].size(); ++l)
        square += (points[i][l] - points[j][l]) * (points[i][l] - points[j][l]);
      closest = std::min(closest, square);
      if (!categories.empty() && categories[i] == categories[j])
        closest_within = std::min(closest_within, square);
      sum += maxpro_term(points[i], points[j]);
    }
  const double pairs = 0.5 * static_cast<double>(points.size()) * static_cast<double>(points.size() - 1);
  return {std::sqrt(closest), closest_within < none ? std::sqrt(closest_within) : 0,
          std::pow(sum / pairs, 1 / static_cast<double>(points[0].size()))};
}

} // namespace platen::study
