#pragma once
// Ludwik and Hollomon hardening beside each other, by least squares over a range of strain (Shahin,
// sections 2.1 and 3.1, after Harthong et al.).

#include "material/hardening.hpp"

namespace platen::material {

struct LudwikFit {
  double sigma_y; ///< Pa
  Ludwik law;
};

/// The Hollomon law nearest to sigma = sigma_y + K eps_p^{1/n}, eps_p = eps - sigma/E, in the least squares
/// of the stress over total strains evenly spread in (0, strain_max].
Hollomon fit_hollomon(const Ludwik&, double sigma_y, double E, double strain_max);

/// The Ludwik law nearest to sigma = kappa eps^{1/m}, eps_p = eps - sigma/E, over the same strains, from the
/// intersection with the elastic line on. sigma_y >= 0.
LudwikFit fit_ludwik(const Hollomon&, double E, double strain_max);

} // namespace platen::material
