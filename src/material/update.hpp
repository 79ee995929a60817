#pragma once
// Material points in principal axes: trial Hencky strains in, Cauchy stresses, new state and tangent out.
// The directions stay those of the trial strain (isotropy), so this is all that a finite element needs.

#include "material/integrator.hpp"
#include "material/models.hpp"

#include <array>
#include <span>

namespace platen::material {

/// What a material point remembers beside its elastic strain.
struct PointUpdate {
  std::array<double, 3> sigma;            ///< principal Cauchy stresses (Pa)
  std::array<double, 3> eps;              ///< principal elastic Hencky strains after the return
  std::array<std::array<double, 3>, 3> D; ///< d(sigma_A)/d(eps_B^tr) (Pa)
  double p, q;                            ///< invariants of sigma (Pa)
  double phi;                             ///< new state
  double plastic_work;                    ///< J_e sigma : d(eps^p), per intermediate volume, end-point stress
  double dv, dw;                          ///< plastic increments of eps_v and eps_q
  Status status;
  Zone zone;
};

/// How a batch went.
struct UpdateCounts {
  long plastic = 0, bracketed = 0, refused = 0;
  long unstable = 0; ///< of the refused
};

/// Updates points independently; spans of equal length. Points whose status is a refusal have unspecified
/// values: the caller must cut its step.
[[nodiscard]] UpdateCounts update(const Model&, std::span<const std::array<double, 3>> eps_trial,
                                  std::span<const double> phi_n, std::span<PointUpdate>);

/// One point with the moduli of the state before the step, which follow only after it: the explicit scheme
/// that Edmans & Sinka's implicit one replaces. For comparison.
[[nodiscard]] PointUpdate update_with_old_moduli(const Model&, const std::array<double, 3>& eps_trial,
                                                 double phi_n);

/// Stored energy of an elastic strain at a state, (K eps_v^2 + 3G eps_q^2)/2 (J per m^3 of intermediate
/// volume).
double stored_energy(const Model&, TrialInvariants elastic, double phi);

/// Volume of the intermediate (unloaded) configuration over the reference volume.
double plastic_volume_ratio(const Model&, double phi);

/// Relative density of the unloaded material; 1 for models without density.
double relative_density(const Model&, double phi);

/// Bounds of the material description active at a state.
Bounds active_bounds(const Model&, double phi);

TrialInvariants invariants(const std::array<double, 3>& eps);

} // namespace platen::material
