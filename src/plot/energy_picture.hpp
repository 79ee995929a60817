#pragma once
// Where the work of a press goes, over the overlap, with the regimes it passes through.

#include "press/curve.hpp"

#include <filesystem>

namespace platen::plot {

/// Mean pressure above; work, stored and dissipated energy of the loading branch below; boundaries of the
/// regimes in both. SVG or PNG by file ending. Throws InvalidInput where there is no work, IoError.
void energy_picture(const press::Curve&, const std::filesystem::path&);

} // namespace platen::plot
