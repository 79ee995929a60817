#pragma once
// The constitutive models, and the one list of them. To add a model: a file beside these that satisfies
// ConstitutiveModel (plasticity.hpp), and one line below.

#include "material/dpc.hpp"
#include "material/drucker_prager.hpp"
#include "material/elastic.hpp"
#include "material/mohr_coulomb.hpp"
#include "material/vmdc.hpp"
#include "material/von_mises.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

namespace platen::material {

/// In the order of the reference page.
using Model = std::variant<Elastic, VonMises, Vmdc, Dpc, DruckerPrager, MohrCoulomb>;

/// A named material, as a card describes it.
struct Material {
  std::string name;
  Model model;
  std::optional<double> tensile_strength = {}; ///< Pa, > 0; it flags fracture, no model knows it
  std::optional<double> density = {}; ///< of the undeformed particle (kg/m^3), > 0; for exports alone
};

/// Young's modulus of the undeformed material (Pa).
double initial_E(const Model&);
/// Poisson's ratio of the undeformed material.
double initial_nu(const Model&);
/// The stress that makes forces dimensionless, F_bar = F/(pi R0^2 sigma_ref): sigma_y of von Mises (uniaxial;
/// with Hollomon hardening kappa) and of VMDC and DPC (hydrostatic, at rho_r0), the uniaxial compressive
/// strength of Drucker-Prager and Mohr-Coulomb, E of an elastic material (Pa).
double reference_stress(const Model&);

/// How cards name it.
std::string_view model_name(const Model&);

/// `use.operator()<M>()` for every model M of the list.
template <class Use> void for_each_model(Use use) {
  [&]<ConstitutiveModel... M>(std::type_identity<std::variant<M...>>) { (use.template operator()<M>(), ...); }
  (std::type_identity<Model>{});
}

/// A vmdc or dpc material on another surface through the same (sigma_y, Gamma, Lambda, epsilon) (Edmans &
/// Sinka, Table 3 with epsilon as in its DPC row): "vmdc", "dpc", or "von-mises", which takes Gamma for its
/// yield stress, perfectly plastic. InvalidInput where that cannot be.
Model run_as(const Model&, std::string_view name);

} // namespace platen::material
