#pragma once
// x^e for x in (0, 1] and e in [0, 16], inlined and without the library's special cases: relative error below
// 5e-13. The unloading curves of soft contacts need it; std::pow costs more than the rest of the law.

#include "platen/law/macros.hpp"

#include <bit>
#include <cstdint>

namespace platen::law::detail {

/// 1/c and ln c of the middles c of 128 parts of [1, 2), for fast_log.
struct LogParts {
  static constexpr int bits = 7, count = 1 << bits;
  double inverse[count] = {}, log[count] = {};
  constexpr LogParts() {
    for (int i = 0; i < count; ++i) {
      const double c = 1 + (i + 0.5) / count, s = (c - 1) / (c + 1), z = s * s;
      inverse[i] = 1 / c;
      double sum = 0, power = s; // ln(1/inverse) is ln c to rounding: 2 (s + s^3/3 + s^5/5 + ...)
      for (int n = 1; n < 40; n += 2, power *= z) sum += power / n;
      log[i] = 2 * sum;
    }
    inverse[0] = 1, log[0] = 0; // exact where x is 1
  }
};
inline constexpr LogParts log_parts;

/// Natural logarithm of a positive normal number, to 1e-15 of 1 or of itself.
PLATEN_HOT double fast_log(double x) {
  const auto bits = std::bit_cast<std::int64_t>(x);
  const std::int64_t k = (bits >> 52) - 1023;
  const double m = std::bit_cast<double>((bits & 0x000f'ffff'ffff'ffff) | 0x3ff0'0000'0000'0000);
  const auto i = static_cast<int>(bits >> (52 - LogParts::bits)) & (LogParts::count - 1);
  const double r = m * log_parts.inverse[i] - 1, r2 = r * r; // |r| < 0.008
  const double series = (-0.5 + r * (1.0 / 3)) + r2 * ((-0.25 + r * 0.2) + r2 * (-1.0 / 6));
  return (static_cast<double>(k) * 0.6931471805599453 + log_parts.log[i]) + (r + r2 * series);
}

/// 2^(i/128) for fast_exp.
struct ExpParts {
  static constexpr int count = 128;
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
  // ln 2/128 in two parts, so that whole times the first is exact
  const double r = (x - whole * 0x1.62e42fefa38p-8) - whole * 0x1.ef35793c7673p-52; // |r| < 0.0028
  const double r2 = r * r;
  const double p = (1 + r) + r2 * ((0.5 + r * (1.0 / 6)) + r2 * (1.0 / 24));
  return p * (exp_parts.value[k & (ExpParts::count - 1)] * std::bit_cast<double>((1023 + (k >> 7)) << 52));
}

PLATEN_HOT double fast_power(double x, double e) {
#if defined(__CUDA_ARCH__) || defined(__HIP_DEVICE_COMPILE__)
  return ::pow(x, e); // tables of the host are not there
#else
  const double y = e * fast_log(x);
  return y > -700 ? fast_exp(y) : 0;
#endif
}

} // namespace platen::law::detail
