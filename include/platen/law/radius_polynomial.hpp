#pragma once

#include "platen/law/macros.hpp"

#include <cmath>

namespace platen::law {

/// a/R = sqrt(x) (D1 - D3 x + D5 x^2): the form of Shahin (2.13), for laws whose paper gives no radius.
template <class Real = double> struct RadiusPolynomial {
  Real D1{}, D3{}, D5{};
  [[nodiscard]] PLATEN_HOT Real a_bar(const Real& x) const {
    using std::sqrt;
    return sqrt(x) * (D1 + x * (D5 * x - D3));
  }

  /// d ln a / d ln x
  [[nodiscard]] PLATEN_FUNCTION Real log_slope(const Real& x) const {
    return Real(0.5) + x * (Real(2) * D5 * x - D3) / (D1 + x * (D5 * x - D3));
  }

  /// The least of it up to x_end, from 64 points and a margin.
  [[nodiscard]] PLATEN_FUNCTION Real least_log_slope(const Real& x_end) const {
    Real least(0.5);
    for (int i = 1; i <= 64; ++i) {
      const Real here = log_slope(x_end * Real(i) / Real(64));
      if (here < least) least = here;
    }
    return least - Real(0.01);
  }
};

} // namespace platen::law
