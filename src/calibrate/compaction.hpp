#pragma once
// A porous material from die compaction: axial and radial stress over relative density, with unloadings, and
// the strengths of tablets (Edmans & Sinka, section 3.4; Cunningham et al. 2004, for the cap).
//
// Compression positive, p = (sigma_a + 2 sigma_r)/3, q = sigma_a - sigma_r.
//   unloading   d sigma_r/d sigma_a = nu/(1 - nu),  d sigma_a/d ln rho = E (1 - nu)/((1 + nu)(1 - 2 nu))
//   strengths   the line q = d + p tan beta through (sigma_c/3, sigma_c), uniaxial, and (2/3 sigma_t,
//   sqrt(13)
//               sigma_t), diametral
//   loading     on the cap, (p - p_a)^2 + (eps q)^2 = (eps Gamma)^2 with Gamma = d + p_a tan beta, whose
//   normal is
//               the plastic strain rate, s = d eps_v/d eps_q (3/2 where nothing is elastic):
//               eps^2 = (p - p_a)/(s q),  s q (p - p_a) + q^2 = (d + p_a tan beta)^2
//   then        sigma_y = p_a + eps Gamma,  Lambda = d/tan beta
// What is elastic of density and strain rate is taken off by E and nu.

#include "material/models.hpp"

#include <string>
#include <vector>

namespace platen::calibrate {

/// In the order of the test.
struct CompactionRow {
  double rho_r, axial_Pa, radial_Pa;
};
struct StrengthRow {
  double rho_r, compressive_Pa, tensile_Pa;
};

/// A quantity over density: value at rho_r0 and growth, exponential or linear.
struct Trend {
  std::string key, growth_key;
  bool exponential = true;
  double value = 0, growth = 0, R2 = 0; ///< R2: of the logarithm where exponential
  double low = 0, high = 0;             ///< densities that it was fitted to
  int points = 0;

  double at(double rho_r, double rho_r0) const;
};

struct Compaction {
  material::Material material;
  std::vector<Trend> trends; ///< sigma_y, E, Gamma, Lambda, nu, epsilon
  int loading_rows = 0, unloadings = 0;
  double axial_l2 = 0, radial_l2 = 0; ///< of a material point led along the loading, relative L2
  std::vector<std::string> said;
};

/// `model`: vmdc or dpc. InvalidInput where the data do not show a parameter.
Compaction compaction(const std::vector<CompactionRow>&, const std::vector<StrengthRow>&, double rho_r0,
                      const std::string& model, const std::string& name);

} // namespace platen::calibrate
