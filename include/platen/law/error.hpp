#pragma once
// `prepare` refuses what cannot be a material or a geometry; nothing else in this folder throws.

#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

namespace platen::law {

/// A parameter is not admissible; the message names it, its value and the range allowed.
struct BadParameter : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// An interval with open or closed ends, as it is written in messages and tables.
struct Range {
  double low = -infinity;
  double high = infinity;
  bool low_open = false;
  bool high_open = false;

  [[nodiscard]] bool contains(double value) const {
    return (low_open ? value > low : value >= low) && (high_open ? value < high : value <= high);
  }
};

inline constexpr Range positive{0, infinity, true, true};
inline constexpr Range non_negative{0, infinity, false, true};
inline constexpr Range radius_or_plane{0, infinity, true, false}; ///< infinity is a plane
inline constexpr Range poisson{0, 0.5, false, true};

/// Six digits, for messages.
inline std::string text(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%g", value);
  return digits;
}

inline std::string text(const Range& range) {
  return (range.low_open ? '(' : '[') + text(range.low) + ", " + text(range.high) +
         (range.high_open ? ')' : ']');
}

inline void require(std::string_view law, std::string_view name, double value, const Range& range) {
  if (range.contains(value)) return; // false for NaN
  throw BadParameter(std::string(law) + ": " + std::string(name) + " = " + text(value) + " is not in " +
                     text(range));
}

/// A rigid-plastic law with a strength above the modulus gives many times the force of an elastic contact.
inline void require_softer_than_elastic(std::string_view law, double kappa, double E) {
  if (!(kappa > E)) return;
  throw BadParameter(std::string(law) + ": kappa_Pa = " + text(kappa) + " is above E_Pa = " + text(E) +
                     ": such a body stays elastic, which this law leaves out; take hertz");
}

} // namespace platen::law
