#pragma once
// `hardening = { kind = ..., ... }` in the parameters of a von Mises card.

#include "material/card_section.hpp"
#include "material/hardening.hpp"

namespace platen::material {

/// The entry of the section, PerfectlyPlastic where there is none. InvalidInput names the rule that is
/// broken.
Hardening read_hardening(const core::Table& parameters);

/// What read_hardening cannot see: InvalidInput where the law does not go with E, or softens so fast that an
/// elastic unloading could not follow it.
void check_hardening(const core::Table& parameters, const Hardening&, double E, double G, double sigma_y);

/// The section in a card; nothing for PerfectlyPlastic.
std::vector<CardEntry> hardening_entries(const Hardening&);

/// The part of the reference page.
std::string hardening_reference();

} // namespace platen::material
