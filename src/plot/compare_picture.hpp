#pragma once
// Laws and curves over one reference curve.

#include "fit/comparison.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace platen::plot {

/// Above, force over overlap: the reference thick, others thin, dashed where a law is outside its validity.
/// Below, force, contact radius and mean pressure over those of the reference, logarithmic in overlap;
/// nothing where the reference has no radius. SVG or PNG by file ending. Throws InvalidInput, IoError.
void compare_picture(const fit::Reference&, const std::vector<fit::Trace>&, const std::string& title,
                     const std::filesystem::path&);

/// Of what was asked and found; without a title that of the reference.
void compare_picture(const fit::Question&, const fit::Comparison&, const std::string& title,
                     const std::filesystem::path&);

} // namespace platen::plot
