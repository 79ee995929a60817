#pragma once
// Yield surfaces as curves in the (p, q) half-plane, to be drawn.

#include "material/models.hpp"

#include <vector>

namespace platen::material {

/// The yield surface at a state, cut off at the pressures p_low < p_high where it goes on without end. None
/// for an elastic material, two meridians for Mohr-Coulomb.
std::vector<YieldCurve> yield_curves(const Model&, double phi, double p_low, double p_high);

} // namespace platen::material
