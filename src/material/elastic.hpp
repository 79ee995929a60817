#pragma once

namespace platen::material {

/// Isotropic elasticity, linear between Hencky strain and Kirchhoff stress.
struct Elastic {
  double E;  ///< Young's modulus (Pa), > 0
  double nu; ///< Poisson's ratio, in [0, 0.5)
};

} // namespace platen::material
