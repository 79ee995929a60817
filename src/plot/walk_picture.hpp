#pragma once
// A material point led along a way, in the plane of pressure and shear stress.

#include "material/models.hpp"
#include "material/walk.hpp"

#include <filesystem>

namespace platen::plot {

/// The way, and the yield surface at up to five of its states, evenly apart. SVG or PNG by file ending.
/// Throws InvalidInput, IoError.
void walk_picture(const material::Material&, const material::Way&, const material::Walk&,
                  const std::filesystem::path&);

} // namespace platen::plot
