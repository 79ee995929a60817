#pragma once
// A curve beside the law that was fitted to it.

#include "fit/fitted_law.hpp"
#include "fit/wang.hpp"
#include "press/curve.hpp"

#include <filesystem>

namespace platen::plot {

/// Curve, law and residual; the unloading branches with their law. SVG or PNG by file ending. Throws
/// InvalidInput, IoError.
void fit_picture(const press::Curve&, const fit::FittedLaw&, const std::filesystem::path&);
void fit_picture(const press::Curve&, const fit::WangFit&, const std::filesystem::path&);

} // namespace platen::plot
