#pragma once
// What a column holds, by the words and units in which instruments head them (English, German, French,
// Japanese).

#include <optional>
#include <string>
#include <string_view>

namespace platen::measure {

enum class Quantity { other, time, force, displacement, particle, diameter, radius, branch };

struct Unit {
  std::string name;                    ///< as it was written
  Quantity measures = Quantity::other; ///< time, force, or displacement: any length
  double in_SI = 1;
};

/// Case matters where it must (mN, MN); gram and kilogram are the forces of these weights.
std::optional<Unit> unit_named(std::string_view);

/// A heading taken apart: "Kraft in N", "Force[mN]", "travel_um", "Load (N)".
struct Heading {
  std::string text; ///< as the file has it
  std::string name; ///< without the unit
  std::string unit; ///< empty where there is none
};
Heading heading_of(std::string_view text);

/// By the words of the name alone.
Quantity quantity_named(std::string_view name);

/// Whether the column is our own delta_m, the approach of one platen: half the travel.
bool is_contact_overlap(std::string_view name);

/// Lower case, without accents, blanks for signs.
std::string folded(std::string_view);

std::string_view words(Quantity);

} // namespace platen::measure
