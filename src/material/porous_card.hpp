#pragma once
// The fields that the cards of porous models share.

#include "material/card_section.hpp"
#include "material/porous.hpp"

namespace platen::material {

/// Ranges at the reference density (Edmans & Sinka, section 3); their linear laws can leave them for nu and
/// epsilon, as in two rows of their Table 4.
template <class M> std::vector<core::Field<M>> porous_fields() {
  using core::any_number, core::Field, core::positive;
  return {
      {"rho_r0", &M::rho_r0, "relative density at which the values hold, and of the undeformed particle",
       core::left_open(0, 1)},
      {"sigma_y_Pa", &M::sigma_y, "hydrostatic yield stress in compression", positive},
      Field<M>{"E_Pa", &M::E, "Young's modulus", positive}.or_ratio("E_bar", "sigma_y_Pa"),
      {"nu", &M::nu, "Poisson's ratio", core::right_open(0, 0.5)},
      Field<M>{"Gamma_Pa", &M::Gamma, "shear strength, largest q", positive}.or_ratio("Gamma_bar",
                                                                                      "sigma_y_Pa"),
      Field<M>{"Lambda_Pa", &M::Lambda, "tensile strength, largest p", positive}.or_ratio("Lambda_bar",
                                                                                          "sigma_y_Pa"),
      {"epsilon", &M::epsilon, "compaction cap: semi-axis along p over semi-axis along q", positive},
      {"eta", &M::eta, "exponent of sigma_y over relative density", any_number},
      {"xi", &M::xi, "exponent of E", any_number},
      {"zeta", &M::zeta, "exponent of Gamma", any_number},
      {"omega", &M::omega, "exponent of Lambda", any_number},
      {"xi_1", &M::xi_1, "slope of nu over relative density", any_number},
      {"xi_2", &M::xi_2, "slope of epsilon over relative density", any_number},
  };
}

} // namespace platen::material
