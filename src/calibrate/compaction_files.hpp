#pragma once
// A porous material from files of die compaction and of tablet strengths, and its card.

#include "calibrate/compaction.hpp"

#include <string>

namespace platen::calibrate {

struct CompactionFiles {
  std::string test; ///< rho_r, axial_stress_MPa, radial_stress_MPa (or _Pa, _kPa), in the order of the test
  std::string strengths; ///< rho_r, compressive_strength_MPa (uniaxial), tensile_strength_MPa (diametral)
  double rho_r0 = 0;     ///< relative density of the granules that will be pressed
  std::string model = "vmdc"; ///< or dpc
  std::string name;           ///< of the material; empty: after the test
};

/// InvalidInput for a file that is no such table, and for data that do not show a parameter.
Compaction compaction(const CompactionFiles&);

/// A few lines for people.
std::string words_of(const Compaction&, const CompactionFiles&);

/// The material card, with what each number is from under [source].
std::string card_of(const Compaction&, const CompactionFiles&);

} // namespace platen::calibrate
