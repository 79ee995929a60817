#pragma once
// x^e for x in (0, 1] and e in [0, 16], inlined and without the library's special cases: relative error below
// 5e-13. The unloading curves of soft contacts need it; std::pow costs more than the rest of the law.

#include "platen/law/macros.hpp"

#include <bit>
#include <cstdint>

namespace platen::law::detail {

/// Natural logarithm of a positive normal number.
PLATEN_HOT double fast_log(double x) {
  auto bits = std::bit_cast<std::int64_t>(x);
  const std::int64_t centred = bits - 0x3fe6'a09e'667f'3bcd; // sqrt(1/2): mantissa into [sqrt(1/2), sqrt(2))
  const std::int64_t k = centred >> 52;
  const double m = std::bit_cast<double>(bits - (k << 52));
  const double s = (m - 1) / (m + 1), z = s * s; // |s| < 0.172; ln m = 2 (s + s^3/3 + s^5/5 + ...)
  const double z2 = z * z, z4 = z2 * z2;
  const double series = z * ((1.0 / 3 + z * (1.0 / 5)) + z2 * (1.0 / 7 + z * (1.0 / 9)) +
                             z4 * ((1.0 / 11 + z * (1.0 / 13)) + z2 * (1.0 / 15 + z * (1.0 / 17))));
  return static_cast<double>(k) * 0.6931471805599453 + 2 * s * (1 + series);
}

/// 2^(i/32) for fast_exp.
struct ExpParts {
  static constexpr int count = 32;
  double value[count] = {};
  constexpr ExpParts() {
    for (int i = 0; i < count; ++i) {
      const double x = i * (0.6931471805599453 / count);
      double sum = 1;
      for (int n = 24; n > 0; --n) sum = 1 + x / n * sum; // Taylor, x < 0.7
      value[i] = sum;
    }
  }
};
inline constexpr ExpParts exp_parts;

/// exp(x) for -700 <= x <= 700.
PLATEN_HOT double fast_exp(double x) {
  // Adding 3 * 2^51 rounds to an integer and leaves it in the low bits of the sum.
  const double shifted = x * (ExpParts::count / 0.6931471805599453) + 0x1.8p52;
  const auto k = std::bit_cast<std::int64_t>(shifted) - std::bit_cast<std::int64_t>(0x1.8p52);
  const double whole = shifted - 0x1.8p52;
  // ln 2/32 in two parts, so that whole times the first is exact
  const double r = (x - whole * 0x1.62e42fefa38p-6) - whole * 0x1.ef35793c7673p-50; // |r| < 0.011
  const double r2 = r * r;
  const double p = (1 + r) + r2 * ((0.5 + r * (1.0 / 6)) + r2 * (1.0 / 24 + r * (1.0 / 120)));
  return p * (exp_parts.value[k & (ExpParts::count - 1)] * std::bit_cast<double>((1023 + (k >> 5)) << 52));
}

PLATEN_HOT double fast_power(double x, double e) {
  const double y = e * fast_log(x);
  return y > -700 ? fast_exp(y) : 0;
}

} // namespace platen::law::detail
