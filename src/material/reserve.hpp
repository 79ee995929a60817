#pragma once

#include "material/models.hpp"

#include <array>

namespace platen::material {

/// The factor by which a stress (principal, Pa, tension positive) may grow until it reaches the yield surface
/// at the state phi: 1 on the surface, above 1 inside, 0 outside. Infinite where it never does, up to a
/// factor of 1e6.
double stress_reserve(const Model&, const std::array<double, 3>& sigma, double phi);

} // namespace platen::material
