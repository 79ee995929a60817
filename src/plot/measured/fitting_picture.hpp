#pragma once
// A fit, whichever it is, as a picture.

#include "measure/fit_law.hpp"

#include <filesystem>
#include <string>

namespace platen::plot {

/// InvalidInput for a law of whose fits there is no picture; to be asked before a fit.
void check_fitting_picture(const std::string& law);

/// As fit_picture(). Throws InvalidInput, IoError.
void fitting_picture(const measure::Fitting&, const std::filesystem::path&);

} // namespace platen::plot
