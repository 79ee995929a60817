#pragma once
// The three ways in which Shahin's laws press a sphere, and the geometry that goes with them.

#include "platen/law/macros.hpp"

#include <cmath>
#include <numbers>

namespace platen::law {

enum class LoadingCase : unsigned char {
  simple,      ///< two contacts, free sides (SC)
  die,         ///< pressed along one axis inside a rigid square die (DC); its primary contacts
  hydrostatic, ///< pressed along three axes (HC)
};

/// chi, volume of the cell over volume of the particle, at x = gamma/2R (2.42). Simple loading has no cell.
template <class Real> PLATEN_FUNCTION Real cell_volume_ratio(LoadingCase loading, const Real& x) {
  const Real h = Real(1) - x;
  const Real six_over_pi(6 / std::numbers::pi);
  return loading == LoadingCase::die ? six_over_pi * h : six_over_pi * h * h * h;
}

/// d chi/dx
template <class Real> PLATEN_FUNCTION Real cell_volume_ratio_slope(LoadingCase loading, const Real& x) {
  const Real h = Real(1) - x;
  const Real six_over_pi(6 / std::numbers::pi);
  return loading == LoadingCase::die ? -six_over_pi : Real(-3) * six_over_pi * h * h;
}

/// The inverse: x at a given chi.
template <class Real> PLATEN_FUNCTION Real x_of_cell_volume_ratio(LoadingCase loading, const Real& chi) {
  using std::cbrt;
  const Real v = chi * Real(std::numbers::pi / 6);
  return Real(1) - (loading == LoadingCase::die ? v : cbrt(v));
}

/// x of the filled cell, chi = 1, the volume unchanged: 1 - pi/6 (DC), 1 - (pi/6)^(1/3) (HC).
PLATEN_FUNCTION double x_of_filled_cell(LoadingCase loading) { return x_of_cell_volume_ratio(loading, 1.0); }

} // namespace platen::law
