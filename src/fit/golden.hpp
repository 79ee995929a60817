#pragma once
// Minimum of a function of one variable without derivatives.

#include <cstddef>

namespace platen::fit {

struct Minimum {
  double at = 0, value = 0;
};

/// Golden section: `evaluations` + 2 calls shrink [low, high] by 0.618 each. Finds a minimum inside or at an
/// end of the interval; the only one when the function has one.
template <class Function>
Minimum golden_section(const Function& f, double low, double high, int evaluations) {
  constexpr double shrink = 0.6180339887498949; // (sqrt(5) - 1)/2
  double left = high - shrink * (high - low), right = low + shrink * (high - low);
  double f_left = f(left), f_right = f(right);
  for (int i = 0; i < evaluations; ++i) {
    if (f_left <= f_right) {
      high = right;
      right = left;
      f_right = f_left;
      left = high - shrink * (high - low);
      f_left = f(left);
    } else {
      low = left;
      left = right;
      f_left = f_right;
      right = low + shrink * (high - low);
      f_right = f(right);
    }
  }
  return f_left <= f_right ? Minimum{left, f_left} : Minimum{right, f_right};
}

/// The same after a look at all `candidates`, ascending: between the neighbours of the best of them.
template <class Function, class Candidates>
Minimum scanned_minimum(const Function& f, const Candidates& candidates, int evaluations) {
  std::size_t best = 0;
  double least = f(candidates[0]);
  for (std::size_t i = 1; i < candidates.size(); ++i)
    if (const double value = f(candidates[i]); value < least) {
      best = i;
      least = value;
    }
  const double low = candidates[best > 0 ? best - 1 : 0];
  const double high = candidates[best + 1 < candidates.size() ? best + 1 : best];
  const Minimum refined = golden_section(f, low, high, evaluations);
  return refined.value < least ? refined : Minimum{candidates[best], least};
}

} // namespace platen::fit
