#pragma once
// The yield stress of a perfectly plastic material from what people know instead.

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

} // namespace platen::surrogate
