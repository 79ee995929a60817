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
  std::string model;           ///< how cards name it
  std::vector<Number> numbers; ///< what the card says, without a unit
  /// What curves are interpolated in: of the same length for every material of a model.
  std::vector<double> coordinates;
};

/// InvalidInput for a model, or a hardening, of which there are no pools.
Description describe(const material::Model&);

} // namespace platen::surrogate
