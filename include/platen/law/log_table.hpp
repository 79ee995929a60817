#pragma once
// A smooth positive function of x as cubics over cells of equal ratio, value and slope exact at the nodes.
// The cell is found from the bits of x: 2^bits cells an octave, a few nanoseconds.

#include "platen/law/cubic.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace platen::law {

template <int bits> class LogTable {
 public:
  struct Sample {
    double value, slope;
  };

  double x_low = 0, x_high = 0;

  /// `sample(x)` gives value and slope; `each_cell(i, left, right, cubic)` sees every cell as it is made.
  template <class SampleAt, class EachCell>
  void make(double low, double high, const SampleAt& sample, const EachCell& each_cell) {
    x_low = low;
    x_high = high;
    base_ = cell_bits(low);
    cells_ = static_cast<int>(cell_bits(high) - base_) + 1;
    cell_.assign(static_cast<std::size_t>(cells_), {});
    double left = low;
    Sample at_left = sample(left);
    for (int i = 0; i < cells_;) {
      // A cell cut very short by an end joins its neighbour: its cubic would be all rounding.
      int last = i;
      if (i == 0 && cells_ > 1 && right_of(0) - left < 1e-3 * left) last = 1;
      if (cells_ - 1 - last == 1 && high - right_of(last) < 1e-3 * high) last = cells_ - 1;
      const double right = last == cells_ - 1 ? high : right_of(last);
      const Sample at_right = sample(right);
      const Cubic cubic =
          Cubic::hermite(right - left, at_left.value, at_left.slope, at_right.value, at_right.slope);
      for (int j = i; j <= last; ++j) cell_[static_cast<std::size_t>(j)] = {left, right - left, cubic};
      each_cell(i, last, left, right, cubic);
      left = right;
      at_left = at_right;
      i = last + 1;
    }
  }

  /// Of a function without its slope: central differences, one-sided at the ends.
  template <class ValueAt> void make(double low, double high, const ValueAt& value) {
    const auto sample = [&](double x) {
      const double down = larger_of(low, x * (1 - 1e-6)), up = smaller_of(high, x * (1 + 1e-6));
      return Sample{value(x), (value(up) - value(down)) / (up - down)};
    };
    make(low, high, sample, [](int, int, double, double, const Cubic&) {});
  }

  PLATEN_HOT void at(double x, double& value, double& slope) const {
    const Cell& c = cell_[index(x)];
    const double t = x - c.left;
    value = c.cubic.value(t);
    slope = c.cubic.slope(t);
  }
  [[nodiscard]] PLATEN_HOT double value(double x) const {
    const Cell& c = cell_[index(x)];
    return c.cubic.value(x - c.left);
  }
  /// From the start of the cell of x to x.
  [[nodiscard]] PLATEN_FUNCTION double integral_in_cell(double x) const {
    const Cell& c = cell_[index(x)];
    return c.cubic.integral(x - c.left);
  }
  /// How far x is through its cell, 0 to 1.
  [[nodiscard]] PLATEN_HOT double share(double x) const {
    const Cell& c = cell_[index(x)];
    return (x - c.left) / c.width;
  }
  [[nodiscard]] PLATEN_HOT std::size_t index(double x) const {
    const auto i = static_cast<int>(cell_bits(x) - base_);
    return static_cast<std::size_t>(i < 0 ? 0 : i < cells_ ? i : cells_ - 1);
  }

 private:
  struct Cell {
    double left = 0, width = 1;
    Cubic cubic;
  };
  static double larger_of(double a, double b) { return a < b ? b : a; }
  static double smaller_of(double a, double b) { return b < a ? b : a; }
  [[nodiscard]] static PLATEN_FUNCTION std::int64_t cell_bits(double x) {
    return std::bit_cast<std::int64_t>(x) >> (52 - bits);
  }
  [[nodiscard]] double right_of(int i) const { return std::bit_cast<double>((base_ + i + 1) << (52 - bits)); }

  std::int64_t base_ = 0;
  int cells_ = 0;
  std::vector<Cell> cell_;
};

} // namespace platen::law
