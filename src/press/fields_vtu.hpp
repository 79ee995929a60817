#pragma once
// Fields of a press as files of VTK, which ParaView and meshio read.

#include "press/confined.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace platen::press {

/// The quarter section at one delta_bar as an unstructured grid of quadrilaterals in the plane x = r, y = z;
/// lengths in m, stresses in Pa, tension positive. Points carry `displacement_m`; cells carry `zone` (as
/// material::Zone counts; that of most of the four Gauss points), the Cauchy stress, p, q, `rho_r`, `phi` and
/// the plastic Hencky strain, all of them means over the cell. `TimeValue` is delta_bar.
std::string fields_vtu(const Snapshot&, double radius_m);

/// The wedge of a confined press in hexahedra, with the same fields.
std::string fields_vtu(const SpatialSnapshot&, double radius_m);

/// "fields-0.1.vtu".
std::string fields_name(double delta_bar);

/// fields.pvd: the series over delta_bar.
std::string fields_series(const std::vector<Snapshot>&);
std::string fields_series(const std::vector<SpatialSnapshot>&);

} // namespace platen::press
