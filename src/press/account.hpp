#pragma once
// What the Gauss points of a solid add up to: a row of the curve, flags.

#include "press/curve.hpp"
#include "press/flow.hpp"

#include <string>
#include <vector>

namespace platen::press {

/// Integrals over the solid (R0^3 Pa).
struct Totals {
  double stored = 0, dissipated = 0; ///< dissipated: since the equilibrium before
};

/// Takes the response at the equilibrium into the flow of the points, and fills zones, densities and largest
/// stresses of the row.
template <fe::Element E>
Totals account_points(const fe::Solid<E>&, const fe::Response<E>&, std::vector<PointFlow<E>>&,
                      const std::vector<PointFlow<E>>& before, CurvePoint& row);

/// Bounds of the material description that were active somewhere, in plain sentences.
template <fe::Element E>
std::vector<std::string> flags_of(const fe::Solid<E>&, const std::vector<PointFlow<E>>&);

} // namespace platen::press
