#pragma once
// The strength by which curves of the local press are made dimensionless.

#include "material/models.hpp"

#include <utility>

namespace platen::press {

/// Friction angle (degrees) and uniaxial compressive strength (Pa) that a model shares with linear
/// Drucker-Prager in triaxial compression: WG (5)-(7), (14), (15). Zeros where there are none.
std::pair<double, double> drucker_prager_strength(const material::Model&);

} // namespace platen::press
