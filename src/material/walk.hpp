#pragma once
// Ways on which a material point is led, by name or step by step.

#include "material/point.hpp"

#include <array>
#include <string>
#include <vector>

namespace platen::material {

using Strains = std::array<double, 3>; ///< principal, logarithmic, extension positive

/// A way by its name (walk_names), or over the total strains of `rows` where the name is none of them.
struct Way {
  std::string name;                ///< isotropic | uniaxial-strain | triaxial | shear, or whence the rows are
  double strain = -0.2;            ///< at the end: of the volume (isotropic), of axis 1
  double lateral_Pa = 0;           ///< triaxial: stress on axes 2 and 3, tension positive
  double compaction = 0;           ///< shear: logarithmic volume lost before, in as many steps
  int steps = 100;                 ///< increments
  std::string moduli = "implicit"; ///< or "after-step": elastic moduli one step late
  std::vector<Strains> rows = {};
};

const std::vector<std::string>& way_names();
bool is_named(const Way&);

/// Columns eps_1, eps_2, eps_3 of a CSV.
std::vector<Strains> read_strains(const std::string& file);

struct Walk {
  std::vector<MaterialPoint> points; ///< the start first
  std::string refusal;               ///< why the way ends early; empty: it does not
};

/// InvalidInput for a number out of its range.
Walk walk(const Model&, const Way&);

} // namespace platen::material
