#pragma once
// First yield of a Drucker-Prager sphere.

namespace platen::fit {

/// Hertz at first yield on the axis: one sphere on a rigid plane, or of two equal ones.
struct FirstYield {
  double F_N, delta_m, contact_radius_m;
};
FirstYield first_yield(double E_Pa, double nu, double phi_deg, double sigma_c_Pa, double radius_m);

} // namespace platen::fit
