#pragma once
// Several numbers at a time: Lanes, eight, of many; Four, as many as an element has. Where the processor has
// no vectors of that length the compiler takes shorter ones (core/vector_clones.hpp). Operators and
// comparisons go number by number, and a comparison gives a mask for `pick`. What is written for a number
// type T with these functions serves double and vectors alike.

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

// Always inlined: a function for one processor would not find the vector that one for another hands it. What
// calls these in a clone is flattened for the same reason.
#define PLATEN_LANES [[gnu::always_inline]] inline

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wpsabi" // no vectors pass between files of different compilers here
#endif

namespace platen::core {

using Lanes = double __attribute__((vector_size(64)));
using Four = double __attribute__((vector_size(32)));
template <class T>
concept Vector = std::is_same_v<T, Lanes> || std::is_same_v<T, Four>;
template <Vector V> inline constexpr int lanes = sizeof(V) / sizeof(double);

/// What a comparison of two T gives: -1 or 0 a number, of a double bool.
template <class T> using Mask = decltype(T{} < T{});

PLATEN_LANES bool any(bool mask) { return mask; }
template <class M>
requires(!std::is_arithmetic_v<M>) PLATEN_LANES bool any(const M& mask) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < sizeof(M) / sizeof(std::int64_t); ++i) sum |= mask[i];
  return sum != 0;
}

PLATEN_LANES bool both(bool a, bool b) { return a && b; }
PLATEN_LANES bool either(bool a, bool b) { return a || b; }
template <class M>
requires(!std::is_arithmetic_v<M>) PLATEN_LANES M both(const M& a, const M& b) { return a & b; }
template <class M>
requires(!std::is_arithmetic_v<M>) PLATEN_LANES M either(const M& a, const M& b) { return a | b; }

/// a where the mask holds, else b.
PLATEN_LANES double pick(bool mask, double a, double b) { return mask ? a : b; }
template <Vector V> PLATEN_LANES V pick(const Mask<V>& mask, const V& a, const V& b) { return mask ? a : b; }

template <Vector V> PLATEN_LANES V side_by_side(const std::array<double, lanes<V>>& x) {
  return std::bit_cast<V>(x);
}
template <Vector V> PLATEN_LANES std::array<double, lanes<V>> apart(const V& x) {
  return std::bit_cast<std::array<double, lanes<V>>>(x);
}

template <Vector V> PLATEN_LANES V sqrt(const V& x) {
  auto root = apart(x);
  for (double& number : root) number = std::sqrt(number);
  return side_by_side<V>(root);
}
template <Vector V> PLATEN_LANES V abs(const V& x) { return x < 0 ? -x : x; }

namespace detail {
inline constexpr double ln_2_high = 0x1.62e42fefap-1, ln_2_low = 0x1.cf79abc9e3b39p-40;
using EightBits = std::uint64_t __attribute__((vector_size(64)));
using FourBits = std::uint64_t __attribute__((vector_size(32)));
template <class T>
using Bits = std::conditional_t<std::is_same_v<T, Lanes>, EightBits,
                                std::conditional_t<std::is_same_v<T, Four>, FourBits, std::uint64_t>>;

/// Taylor's sum to the 13th power, even and odd ones apart: |r| <= ln(2)/2 leaves 4e-18 over.
template <class T> PLATEN_LANES T exp_near_0(const T& r) {
  const T r2 = r * r;
  const T even =
      1 + r2 * (1 / 2.0 +
                r2 * (1 / 24.0 +
                      r2 * (1 / 720.0 + r2 * (1 / 40320.0 + r2 * (1 / 3628800.0 + r2 * (1 / 479001600.0))))));
  const T odd =
      1 +
      r2 * (1 / 6.0 +
            r2 * (1 / 120.0 +
                  r2 * (1 / 5040.0 + r2 * (1 / 362880.0 + r2 * (1 / 39916800.0 + r2 * (1 / 6227020800.0))))));
  return even + r * odd;
}

/// Of x within 708.
template <class T> PLATEN_LANES T exp_within(const T& x) {
  constexpr double per_ln_2 = 1.44269504088896340736;
  constexpr double shift = 0x1.8p52; // a whole number added to it stands in its last bits
  const T shifted = x * per_ln_2 + shift, n = shifted - shift;
  const T r = x - n * ln_2_high - n * ln_2_low;
  return std::bit_cast<T>(
      Bits<T>(std::bit_cast<Bits<T>>(T(exp_near_0(r))) + (std::bit_cast<Bits<T>>(shifted) << 52)));
}

/// Of positive, normal, finite x.
template <class T> PLATEN_LANES T log_of_normal(const T& x) {
  // x = m 2^n, m from sqrt(1/2) to sqrt(2). The exponent is moved to a positive number, and n read out of the
  // last bits of a double.
  constexpr std::uint64_t root = 0x3fe6a09e667f3bcd, one = std::uint64_t{1} << 52, moved = 2048;
  const Bits<T> n_bits = ((std::bit_cast<Bits<T>>(x) - root + moved * one) >> 52) & 0xfff;
  const T m = std::bit_cast<T>(Bits<T>(std::bit_cast<Bits<T>>(x) - ((n_bits - moved) << 52)));
  const T n = std::bit_cast<T>(Bits<T>(n_bits | 0x4330000000000000)) - (0x1p52 + static_cast<double>(moved));
  // log(m) = 2 artanh(s), |s| <= 0.172: eleven terms leave 1e-18 over.
  const T s = (m - 1) / (m + 1), s2 = s * s, s4 = s2 * s2;
  const T even = 1 + s4 * (1 / 5.0 + s4 * (1 / 9.0 + s4 * (1 / 13.0 + s4 * (1 / 17.0 + s4 * (1 / 21.0)))));
  const T odd = 1 / 3.0 + s4 * (1 / 7.0 + s4 * (1 / 11.0 + s4 * (1 / 15.0 + s4 * (1 / 19.0))));
  return n * ln_2_high + (n * ln_2_low + 2 * s * (even + s2 * odd));
}
} // namespace detail

/// To a relative 5e-16; of x within 708, beyond that the value there.
template <Vector V> PLATEN_LANES V exp(const V& x) {
  const V bounded = x > 708 ? V{} + 708 : x < -708 ? V{} - 708 : x;
  return x == x ? detail::exp_within(bounded) : x;
}

/// To a relative 7e-16, of positive, normal, finite numbers; NaN else.
template <Vector V> PLATEN_LANES V log(const V& x) {
  using Limits = std::numeric_limits<double>;
  return both(x >= Limits::min(), x <= Limits::max()) ? detail::log_of_normal(x) : V{} + Limits::quiet_NaN();
}

#undef PLATEN_LANES

} // namespace platen::core
