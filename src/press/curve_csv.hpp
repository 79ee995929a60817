#pragma once
// curve.csv: the curve of a press as text, to be read by anything.

#include "press/curve.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace platen::press {

std::string curve_csv(const Curve&);
void write_curve(const Curve&, const std::filesystem::path&);

/// F_bar of every point from its force.
void set_reference_stress(Curve&, double sigma_ref_Pa);

/// A curve written by write_curve; or a measured one, with the columns delta_m and force_N alone, whose
/// radius is given here or as a line "# radius_m = ..."; two that differ are refused. What a measured curve
/// does not say stays 0 (sigma_ref_Pa, E_Pa, nu and, without sigma_ref_Pa, F_bar). InvalidInput names file,
/// line and column.
Curve read_curve(const std::filesystem::path&, std::optional<double> radius_m = {});
Curve parse_curve(const std::string& text, const std::string& file, std::optional<double> radius_m = {});

} // namespace platen::press
