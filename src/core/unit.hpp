#pragma once
// Keys carry SI units. Who writes a value with its unit under the bare name, E = "2 GPa", is understood; who
// writes another unit into the key is told the line to write instead.

#include "core/toml.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace platen::core {

/// E_MPa = 100 with E_Pa known → "E_Pa = 1e8"; without a unit, E = 100 → "E_Pa, in Pa"; empty when the key
/// is not a known one in another unit.
std::string line_in_si(std::string_view key, const Value&, std::span<const std::string> known);

/// How many units of `key` one unit of `other` is: ("E_Pa", "modulus_MPa") → 1e6; 1 where neither has a
/// unit. InvalidInput where they measure different things, or one has no unit.
double in_units_of(std::string_view key, std::string_view other);

/// A number with its unit.
struct Quantity {
  double in_si = 0;
  std::string si; ///< as keys end: "Pa", "m", "m_per_N", "kg_per_m3"
};

/// "0.5 mm", "2GPa", "1.5 g/cm³", "0.4 µm/N"; nothing for anything else.
std::optional<Quantity> quantity_from(std::string_view text);

/// The known key that a bare name stands for: "E" → "E_Pa"; empty where there is none.
std::string si_key(std::string_view bare, std::span<const std::string> known);
/// The value of that key in its unit. InvalidInput, beginning with `place`, for what has no unit, or one of
/// something else.
double value_in_si(std::string_view place, std::string_view text, std::string_view key);

/// The table with such entries under their SI keys; numbers, and lists of them. Nothing where there are none.
/// InvalidInput as above, and where a value stands there under both names.
std::optional<Table> in_si(const Table&, std::span<const std::string> known);

} // namespace platen::core
