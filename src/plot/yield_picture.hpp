#pragma once
// Yield surfaces and a stress path in the plane of pressure and shear stress.

#include "material/plasticity.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace platen::plot {

struct NamedCurve {
  std::string name;
  std::vector<std::array<double, 2>> p_q; ///< Pa, tension positive
};

struct StressPath {
  std::vector<std::array<double, 2>> p_q;
  std::vector<material::Zone> zones; ///< of each point
};

/// Pressure -p to the right, q upwards; the curves from light to dark, the path in the colours of its zones.
/// SVG or PNG by file ending.
void yield_picture(const std::vector<NamedCurve>&, const StressPath&, const std::string& title,
                   const std::filesystem::path& file);

} // namespace platen::plot
