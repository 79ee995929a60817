#pragma once
// A law in the words of codes that take two numbers: the nearest Hertz contact and the nearest hysteretic
// springs, and how far each is off.

#include "fit/law_card.hpp"

#include <array>
#include <string>
#include <vector>

namespace platen::dem {

struct TwoParameters {
  double radius_m = 0, delta_bar = 0; ///< of two equal spheres, and how far they are pressed
  double nu = 0.3;                    ///< of the card, else 0.3
  bool nu_given = false;
  double E_Pa = 0;        ///< F = 4/3 E* sqrt(R/2) gamma^(3/2), E* = E/(2 (1 - nu^2)), nearest in relative L2
  double hertz_error = 0; ///< relative L2 of the force over the loading
  double k_1_N_per_m = 0; ///< F = k_1 gamma, likewise
  double k_2_N_per_m = 0; ///< of unloading: k_1/e^2, so that as much work is given back from the end
  double springs_error = 0;
  double restitution = 1; ///< e = sqrt(work given back/work spent) from the end of the loading
  std::vector<std::array<double, 2>> restitutions; ///< delta/R and e: what a constant e would have to be
};

/// InvalidInput for a range that is none.
TwoParameters two_parameters(const fit::LawCard&, double radius_m, double delta_bar);

std::string words_of(const TwoParameters&, const fit::LawCard&);

} // namespace platen::dem
