#pragma once
// The strength of a Mohr-Coulomb card, by cohesion or by uniaxial compressive strength.

#include "core/fields.hpp"
#include "material/mohr_coulomb.hpp"

namespace platen::material {

/// Exactly one of cohesion_Pa and sigma_c_Pa; psi_deg or associated.
/// `others`: keys of the section that somebody else reads.
MohrCoulomb read_mohr_coulomb(const core::Table& parameters, std::span<const std::string> others);

/// The fields as they are written: by cohesion_Pa and psi_deg.
const std::vector<core::Field<MohrCoulomb>>& mohr_coulomb_fields();

/// Every field that may be given.
std::vector<core::FieldInfo> mohr_coulomb_infos();

} // namespace platen::material
