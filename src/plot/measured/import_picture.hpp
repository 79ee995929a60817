#pragma once
// What an instrument wrote, and what is left of it when the contact point, the zero of the load cell and the
// give of the machine are taken off.

#include "measure/machine.hpp"
#include "measure/specimen.hpp"
#include "measure/stages.hpp"

#include <filesystem>
#include <vector>

namespace platen::plot {

/// Left, force over travel as measured, by what happens in each row. Right the same, corrected: F/(pi R^2)
/// over delta/R, or where no diameter is known, force over delta; above it, what was taken off. SVG or PNG by
/// file ending. Throws InvalidInput, IoError.
void import_picture(const measure::Measurement&, const std::vector<measure::Stages>&, const measure::Machine&,
                    const std::filesystem::path&);

} // namespace platen::plot
