#include "study/derived.hpp"

#include "material/models.hpp"

namespace platen::study {
namespace {

/// Bulk modulus over sigma_ref, SH chapter 2.
double zeta_of(const press::Case& c) {
  const auto& model = c.material.model;
  return material::initial_E(model) /
         (3 * (1 - 2 * material::initial_nu(model)) * material::reference_stress(model));
}

} // namespace

double lambda_of(const press::Case& c) {
  const auto& model = c.material.model;
  const double nu = material::initial_nu(model);
  return material::initial_E(model) / ((1 - nu * nu) * material::reference_stress(model));
}

const std::vector<Derived>& derived_quantities() {
  static const std::vector<Derived> list = {
      {"lambda", "E/((1 - nu^2) sigma_ref), SH section 2.2; sigma_ref is sigma_y of a von Mises material",
       lambda_of},
      {"zeta", "bulk modulus over sigma_ref, E/(3 (1 - 2 nu) sigma_ref)", zeta_of},
  };
  return list;
}

} // namespace platen::study
