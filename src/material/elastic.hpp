#pragma once

#include "material/plasticity.hpp"

namespace platen::material {

/// Isotropic elasticity: Hencky strain, stored energy (K eps_v^2 + 3G eps_q^2)/2 per undeformed volume.
struct Elastic {
  double E;  ///< Young's modulus (Pa), > 0
  double nu; ///< Poisson's ratio, in [0, 0.5)

  static constexpr std::string_view name = "elastic";
  static const CardSection<Elastic>& card();

  double reference_stress() const { return E; }
  Moduli moduli(double) const { return isotropic_moduli(E, nu); }
};

} // namespace platen::material
