#pragma once
// The curve of a press beside a law.

#include "fit/unloading.hpp"
#include "press/curve.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace platen::plot {

/// Loading branch, law, and below them the residual (F_law - F)/F_max; unloading and reloading branches drawn
/// thin. delta_bar and F_bar_law: the law as it is to be drawn, ascending in delta_bar; its residual is
/// interpolated to the points of the curve, its errors stand beside its name. `unloading` adds the law's
/// unloading branches. Lengths and forces in SI on the second axes where the curve says its radius and
/// reference stress. SVG or PNG by file ending. Throws InvalidInput, IoError.
void curve_with_law(const press::Curve& curve, const std::vector<double>& delta_bar,
                    const std::vector<double>& F_bar_law, const std::string& law_name,
                    const std::filesystem::path& file, const std::vector<fit::UnloadingFit>& unloading = {});

/// The curve alone.
void curve_picture(const press::Curve& curve, const std::filesystem::path& file);

} // namespace platen::plot
