#pragma once
// `hardening = { kind = ..., ... }` in the parameters of a von Mises card.

#include "core/toml.hpp"
#include "material/hardening.hpp"

#include <string>
#include <utility>
#include <vector>

namespace platen::material {

/// The entry of the section, PerfectlyPlastic where there is none. InvalidInput names the rule that is
/// broken.
Hardening read_hardening(const core::Table& parameters);

/// What read_hardening cannot see: InvalidInput where the law does not go with E, or softens so fast that an
/// elastic unloading could not follow it.
void check_hardening(const core::Table& parameters, const Hardening&, double E, double G, double sigma_y);

/// The entry as a line of a card; empty for PerfectlyPlastic.
std::string hardening_line(const Hardening&);

/// Name, value in SI units and meaning of the law's numbers.
std::vector<std::pair<std::string, std::pair<double, std::string>>> hardening_numbers(const Hardening&);

/// The part of the reference page.
std::string hardening_reference();

} // namespace platen::material
