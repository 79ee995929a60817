#pragma once
// x^b for one fixed b, several times faster than std::pow: the mantissa from cubics, the exponent from a
// list. Relative error below 1e-11 for b in [0, 3] and x in [2^-100, 2^100].

#include "platen/law/log_table.hpp"

#include <cmath>

namespace platen::law {

class PowerTable {
 public:
  void make(double b) {
    for (int i = 0; i < cells; ++i) {
      const double left = 1 + i * width, right = left + width;
      cell_[i] = Cubic::hermite(width, std::pow(left, b), b * std::pow(left, b - 1), std::pow(right, b),
                                b * std::pow(right, b - 1));
    }
    for (int e = -reach; e <= reach; ++e) scale_[e + reach] = std::exp2(b * e);
  }
  [[nodiscard]] PLATEN_FUNCTION bool covers(double x) const { return x > 0x1p-100 && x < 0x1p100; }

  [[nodiscard]] PLATEN_HOT double value(double x) const {
    const auto bits = std::bit_cast<std::int64_t>(x);
    const auto i = static_cast<int>((bits >> (52 - mantissa_bits)) & (cells - 1));
    const double mantissa = std::bit_cast<double>((bits & 0x000f'ffff'ffff'ffff) | 0x3ff0'0000'0000'0000);
    return cell_[i].value(mantissa - (1 + i * width)) * scale_[(bits >> 52) - 1023 + reach];
  }

 private:
  static constexpr int mantissa_bits = 7, cells = 1 << mantissa_bits, reach = 100;
  static constexpr double width = 1.0 / cells;
  Cubic cell_[cells];
  double scale_[2 * reach + 1] = {};
};

} // namespace platen::law
