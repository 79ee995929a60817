#pragma once
// What the lines beside the numbers say about the particle.

#include "measure/sheet.hpp"

#include <optional>
#include <string>

namespace platen::measure {

/// "granule 1, height 1.20 mm", "Durchmesser [mm]: 10,00": a length that is the particle's diameter, or half
/// of it where a radius stands there [m]. Nothing where there is none, or none with a unit.
std::optional<double> diameter_in(const std::string& text, const Dialect&);

/// Whether the line names a particle: "Test No. 3", "granule 1", a diameter.
bool names_particle(const std::string& text, const Dialect&);

/// The name without what else stands in the line.
std::string particle_name(const std::string& text);

} // namespace platen::measure
