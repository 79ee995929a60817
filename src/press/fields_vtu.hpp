#pragma once
// Fields of a press as files of VTK, which ParaView and meshio read.

#include "press/result.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace platen::press {

/// The mesh at one delta_bar as an unstructured grid: a quarter section of quadrilaterals in the plane x = r,
/// y = z, or a wedge of hexahedra; lengths in m, stresses in Pa, tension positive. Points carry
/// `displacement_m`; cells carry `zone` (as material::Zone counts; prevailing() at the Gauss points), the
/// Cauchy stress, p, q, `rho_r`, `phi` and the plastic Hencky strain, all of them means over the cell.
/// `TimeValue` is delta_bar.
template <fe::Element E> std::string fields_vtu(const SnapshotOf<E>&, double radius_m);

/// "fields-0.1.vtu".
std::string fields_name(double delta_bar);

/// fields.pvd: the series over delta_bar.
template <fe::Element E> std::string fields_series(const std::vector<SnapshotOf<E>>&);

} // namespace platen::press
