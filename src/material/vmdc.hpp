#pragma once

namespace platen::material {

/// von Mises Double Cap (Edmans & Sinka, Table 2, eqs 3a-5b), initial values at rho_r0.
struct Vmdc {
  double rho_r0;  ///< relative density of the undeformed material, in (0, 1]
  double sigma_y; ///< hydrostatic yield stress in compression (Pa), > 0
  double E;       ///< Young's modulus (Pa), > 0
  double nu;      ///< Poisson's ratio, in [0, 0.5)
  double Gamma;   ///< shear strength, largest q (Pa), > 0
  double Lambda;  ///< tensile strength, largest p (Pa), > 0
  double epsilon; ///< p-semi-axis over q-semi-axis of the compaction cap, > 0
  double eta;     ///< exponent of sigma_y
  double xi;      ///< exponent of E
  double zeta;    ///< exponent of Gamma
  double omega;   ///< exponent of Lambda
  double xi_1;    ///< slope of nu over rho_r
  double xi_2;    ///< slope of epsilon over rho_r
};

} // namespace platen::material
