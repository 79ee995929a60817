#pragma once
// The strength of a Drucker-Prager card, which may be given in three ways.

#include "core/fields.hpp"
#include "material/drucker_prager.hpp"

namespace platen::material {

/// Exactly one of beta_deg + sigma_c_Pa, phi_deg + sigma_c_Pa, phi_deg + cohesion_Pa; psi_deg or associated.
/// `others`: keys of the section that somebody else reads.
DruckerPrager read_drucker_prager(const core::Table& parameters, std::span<const std::string> others);

/// The fields as they are written: by beta_deg, sigma_c_Pa, psi_deg.
const std::vector<core::Field<DruckerPrager>>& drucker_prager_fields();

/// Every field that may be given.
std::vector<core::FieldInfo> drucker_prager_infos();

} // namespace platen::material
