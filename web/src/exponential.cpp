// In place of the toolchain's exponential, which takes twice the time: the one with which the program
// computes many at once, of one number, to a relative 5e-16.

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

extern "C" double exp(double x) {
  if (!(x > -708)) return std::isnan(x) ? x : x < -745.2 ? 0 : exp(x + 64) * 0x1.969d47321e4ccp-93; // e^-64
  if (x > 709) return x > 709.79 ? std::numeric_limits<double>::infinity() : exp(x - 1) * 0x1.5bf0a8b145769p1;
  constexpr double per_ln_2 = 1.44269504088896340736, shift = 0x1.8p52;
  constexpr double ln_2_high = 0x1.62e42fefap-1, ln_2_low = 0x1.cf79abc9e3b39p-40;
  const double shifted = x * per_ln_2 + shift, n = shifted - shift;
  const double r = x - n * ln_2_high - n * ln_2_low, r2 = r * r;
  const double even =
      1 + r2 * (1 / 2.0 +
                r2 * (1 / 24.0 +
                      r2 * (1 / 720.0 + r2 * (1 / 40320.0 + r2 * (1 / 3628800.0 + r2 * (1 / 479001600.0))))));
  const double odd =
      1 +
      r2 * (1 / 6.0 +
            r2 * (1 / 120.0 +
                  r2 * (1 / 5040.0 + r2 * (1 / 362880.0 + r2 * (1 / 39916800.0 + r2 * (1 / 6227020800.0))))));
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(even + r * odd) +
                               (std::bit_cast<std::uint64_t>(shifted) << 52));
}
