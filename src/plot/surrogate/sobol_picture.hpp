#pragma once
// Sobol indices as bars.

#include "surrogate/sobol.hpp"

#include <filesystem>

namespace platen::plot {

/// Total indices of each number, a bar an output, the index alone as the full part of it; the numbers that
/// matter most first.
void sobol_picture(const surrogate::Sensitivity&, const std::filesystem::path& file);

} // namespace platen::plot
