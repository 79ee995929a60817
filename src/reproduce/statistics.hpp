#pragma once
// Small sums over numbers.

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace platen::reproduce {

/// Between the two in the middle of an even count.
inline double median(std::vector<double> v) {
  std::ranges::sort(v);
  const std::size_t half = v.size() / 2;
  return v.size() % 2 ? v[half] : (v[half - 1] + v[half]) / 2;
}

inline double largest(const std::vector<double>& v) { return *std::ranges::max_element(v); }
inline double least(const std::vector<double>& v) { return *std::ranges::min_element(v); }

inline double mean(const std::vector<double>& v) {
  double sum = 0;
  for (const double x : v) sum += x;
  return sum / static_cast<double>(v.size());
}

/// 1 - sum (law - y)^2 / sum (y - mean y)^2
inline double r_squared(const std::vector<double>& y, const std::vector<double>& law) {
  const double middle = mean(y);
  double off = 0, spread = 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    off += (law[i] - y[i]) * (law[i] - y[i]);
    spread += (y[i] - middle) * (y[i] - middle);
  }
  return 1 - off / spread;
}

/// Values of f at each of x.
inline std::vector<double> values(const std::vector<double>& x, const std::function<double(double)>& f) {
  std::vector<double> y;
  for (const double at : x) y.push_back(f(at));
  return y;
}

/// So many points from one end to the other.
inline std::vector<double> even(double from, double to, int points) {
  std::vector<double> x;
  for (int i = 0; i < points; ++i) x.push_back(from + (to - from) * i / (points - 1));
  return x;
}

/// The same, even in the logarithm.
inline std::vector<double> even_in_logarithm(double from, double to, int points) {
  std::vector<double> x = even(std::log(from), std::log(to), points);
  for (double& value : x) value = std::exp(value);
  return x;
}

} // namespace platen::reproduce
