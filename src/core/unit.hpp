#pragma once
// Keys carry SI units. Who writes another one is told the line to write instead.

#include "core/toml.hpp"

#include <span>
#include <string>
#include <string_view>

namespace platen::core {

/// E_MPa = 100 with E_Pa known → "E_Pa = 1e8"; without a unit, E = 100 → "E_Pa, in Pa"; empty when the key
/// is not a known one in another unit.
std::string line_in_si(std::string_view key, const Value&, std::span<const std::string> known);

/// How many units of `key` one unit of `other` is: ("E_Pa", "modulus_MPa") → 1e6; 1 where neither has a
/// unit. InvalidInput where they measure different things, or one has no unit.
double in_units_of(std::string_view key, std::string_view other);

} // namespace platen::core
