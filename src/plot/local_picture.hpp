#pragma once
// Pictures of a local press, Hertz beside it: WG Figs 2, 3 and 5.

#include "press/result.hpp"

#include <filesystem>

namespace platen::plot {

/// Force over the Hertz-consistent approach, loading and branches, with first yield on the axis.
void approach_picture(const press::Result&, const std::filesystem::path& file);

/// Peak contact pressure and largest von Mises stress over the force.
void peaks_picture(const press::Result&, const std::filesystem::path& file);

/// Contact pressure over the radius, at each load that was asked for.
void pressure_picture(const press::Result&, const std::filesystem::path& file);

/// Plastic strain under the contact (element means), at each of these loads: bands between
/// press::joining_strains.
void plastic_zone_picture(const press::Result&, const std::filesystem::path& file);

// All four: SVG or PNG by file ending; throw InvalidInput where there is nothing to draw, IoError.

} // namespace platen::plot
