#pragma once
// The yield stress of a perfectly plastic material, or a granule, from what people know instead.

#include "material/vmdc.hpp"

namespace platen::surrogate {

/// From the indentation hardness H (Vickers, Brinell, a ball pressed in): sigma_y = H/2.8 (Tabor 1951: 2.8 to
/// 3), in Pa. That holds where the indentation is fully plastic and the material hardens little. InvalidInput
/// where it cannot be fully plastic: E tan(beta)/((1 - nu^2) sigma_y) below 30 (Johnson 1985, 6.3; Vickers as
/// a cone of beta = 19.7 degrees to the surface).
double yield_from_hardness(double E_Pa, double nu, double H_Pa);

/// From the yield pressure of a powder in tablets, the slope of Heckel's line ln 1/(1 - D) = P/P_y + A out of
/// the die: sigma_y = P_y/3 (Heckel 1961), in Pa. It takes the grains for solid and perfectly plastic, and so
/// hard that they do not spring back: InvalidInput for E/sigma_y below 30.
double yield_from_heckel(double E_Pa, double nu, double P_y_Pa);

/// From the force F that a sphere of radius R carries between two plates at the overlap delta of each (half
/// of what the plates have come together): that sigma_y for which the surrogate of perfectly plastic metals
/// says F. InvalidInput where delta/R is not in 0.01 to 0.5, or no sigma_y of the pool's range gives F: a
/// force above is more than E allows.
double yield_from_crushing(double E_Pa, double nu, double F_N, double delta_m, double radius_m);

/// Indices of tableting (Hiestand & Smith 1984), of compacts of one relative density.
struct Indices {
  double strain = 0;      ///< H/E', E' = E/(1 - nu^2)
  double bonding = 0;     ///< sigma_T/H, sigma_T in tension along one axis
  double hardness_Pa = 0; ///< H
  double relative_density = 0;
};

/// The granule of relative density 0.7 that such compacts are, where the base case of Edmans & Sinka says
/// what indices do not: Gamma = H/2.8 as for a metal (it gets no denser under the indenter), E from the
/// strain index, Lambda from sigma_T on the tension cap; from the density of the compacts to 0.7 along the
/// exponents of the base case. So E_bar stands for the strain index, Lambda_bar for the bonding index (their
/// section 3.2). InvalidInput where the indentation is partly elastic, or sigma_T above Gamma.
material::Vmdc granule_from(const Indices&);

} // namespace platen::surrogate
