#pragma once
// Numbers of a published law that a fit to one's own curve may replace, one by one.

#include "platen/law/error.hpp"

#include <array>
#include <string_view>

namespace platen::law {

inline constexpr Range finite{-infinity, infinity, true, true};

template <class Coefficients> struct Coefficient {
  std::string_view key; ///< in a law card
  std::string_view meaning;
  Range range;
  double Coefficients::*member;
};

/// `published`, but where `given` is not 0. Throws BadParameter.
template <class Coefficients, std::size_t n>
Coefficients with_given(std::string_view law, const std::array<Coefficient<Coefficients>, n>& table,
                        Coefficients published, const Coefficients& given) {
  for (const auto& c : table) {
    if (given.*c.member == 0) continue;
    require(law, c.key, given.*c.member, c.range);
    published.*c.member = given.*c.member;
  }
  return published;
}

/// Refuses coefficients with which force would fall, or the radius vanish, between two overlaps. Throws
/// BadParameter.
template <class Curve>
void require_rising(std::string_view law, const Curve& curve, double x_from, double x_to) {
  for (int i = 0; i <= 256; ++i) {
    const double x = x_from + (x_to - x_from) * i / 256;
    const auto point = curve.at(x);
    if (point.a > 0 && point.F > 0 && point.slope >= 0) continue;
    throw BadParameter(std::string(law) +
                       ": with these coefficients force or contact radius falls at delta/R = " + text(x));
  }
}

} // namespace platen::law
