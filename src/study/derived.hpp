#pragma once
// Named quantities that follow from a case: what [bounds] of a study may limit.

#include "press/case.hpp"

#include <string>
#include <vector>

namespace platen::study {

struct Derived {
  std::string name, meaning;
  double (*of)(const press::Case&);
};
/// lambda first.
const std::vector<Derived>& derived_quantities();

/// E/((1 - nu^2) sigma_ref), SH section 2.2; sigma_ref is sigma_y of a von Mises material.
double lambda_of(const press::Case&);

} // namespace platen::study
