#pragma once
// The constitutive models, and the one list that names them. To add a model: a header beside these, and one
// line below.

#include "material/drucker_prager.hpp"
#include "material/elastic.hpp"
#include "material/vmdc.hpp"
#include "material/von_mises.hpp"

#include <string>
#include <variant>

namespace platen::material {

using Model = std::variant<Elastic, VonMises, Vmdc, DruckerPrager>;

/// A named material, as a card describes it.
struct Material {
  std::string name;
  Model model;
};

/// Young's modulus of the undeformed material (Pa).
double initial_E(const Model&);
/// Poisson's ratio of the undeformed material.
double initial_nu(const Model&);
/// The stress that makes forces dimensionless, F_bar = F/(pi R0^2 sigma_ref): sigma_y of von Mises (uniaxial;
/// with Hollomon hardening kappa) and of VMDC (hydrostatic, at rho_r0), sigma_c of Drucker-Prager, E of an
/// elastic material (Pa).
double reference_stress(const Model&);

} // namespace platen::material
