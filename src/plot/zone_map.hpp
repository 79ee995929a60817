#pragma once
// Where the particle flows, and how: ES Figs 8 and 10.

#include "press/result.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace platen::plot {

/// "#rrggbb" and name of a zone, the same in every picture.
std::string zone_colour(press::Zone);
std::string zone_name(press::Zone);

/// Flow of the last increment in the colours of ES section 5.2 (compaction red, shear yellow, tension green,
/// elastic blue), a quarter of each element a Gauss point, the full section mirrored from the computed
/// quarter; one panel a snapshot. SVG or PNG by file ending. Throws InvalidInput, IoError.
void zone_map(const std::vector<press::Snapshot>& snapshots, const std::string& title,
              const std::filesystem::path& file);

} // namespace platen::plot
