#pragma once

namespace platen::material {

/// von Mises, perfectly plastic: q = sigma_y in Cauchy stress.
struct VonMises {
  double E;       ///< Young's modulus (Pa), > 0
  double nu;      ///< Poisson's ratio, in [0, 0.5)
  double sigma_y; ///< uniaxial yield stress (Pa), > 0
};

} // namespace platen::material
