#pragma once
// A material as a surrogate sees it: dimensionless numbers.

#include "material/models.hpp"

#include <string>
#include <vector>

namespace platen::surrogate {

struct Number {
  std::string key; ///< as in a material card: "E_bar", "rho_r0"
  double value;
  bool log = false; ///< varies by factors
};

struct Description {
  std::string model;           ///< how cards name it; of metals that harden with "-hardening" behind
  std::vector<Number> numbers; ///< what the card says, without a unit
  /// What curves are interpolated in: of the same length for every material of a model.
  std::vector<double> coordinates;
  double sigma_ref = 0; ///< F_bar of its pool is over this stress [Pa]
  double E_flat = 0;    ///< E/(1 - nu^2) over sigma_ref
};

/// InvalidInput for a model, or a hardening, of which there are no pools.
Description describe(const material::Model&);

} // namespace platen::surrogate
