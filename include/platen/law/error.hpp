#pragma once
// `prepare` refuses what cannot be a material or a geometry; nothing else in this folder throws.

#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
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

inline std::string text(const Range& range) {
  std::ostringstream out;
  out << (range.low_open ? '(' : '[') << range.low << ", " << range.high << (range.high_open ? ')' : ']');
  return out.str();
}

inline void require(std::string_view law, std::string_view name, double value, const Range& range) {
  if (range.contains(value)) return; // false for NaN
  std::ostringstream out;
  out << law << ": " << name << " = " << value << " is not in " << text(range);
  throw BadParameter(out.str());
}

/// A rigid-plastic law with a strength above the modulus gives many times the force of an elastic contact.
inline void require_softer_than_elastic(std::string_view law, double kappa, double E) {
  if (!(kappa > E)) return;
  std::ostringstream out;
  out << law << ": kappa_Pa = " << kappa << " is above E_Pa = " << E
      << ": such a body stays elastic, which this law leaves out; take hertz";
  throw BadParameter(out.str());
}

} // namespace platen::law
