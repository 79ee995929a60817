#pragma once
// Where a geomaterial starts to yield: what Wang et al. tabulate (Table 3), and the edge of the contact,
// which they leave out.

#include "platen/law/parameter_reader.hpp"

namespace platen::fit {

struct InitialYield {
  double F_y_N = 0;        ///< on the axis; the unit of force of the law wang
  double gamma_y_m = 0;    ///< whole approach of the centres
  double depth_over_a = 0; ///< of first yield, over the contact radius
  double p0_Pa = 0;        ///< peak pressure there
  double F_y_edge_N = 0;   ///< the edge of the contact yields
};

/// Of two bodies of the law wang that its parameters describe: the one that yields first; they share strength
/// and friction. InvalidInput for what is no geometry or material.
InitialYield initial_yield(const law::ParameterTexts&);

} // namespace platen::fit
