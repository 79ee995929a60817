#pragma once
// Which columns of a table are force, travel and time, and in which units.

#include "measure/sheet.hpp"
#include "measure/specimen.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace platen::measure {

/// Columns of one specimen, by index in the table.
struct Group {
  std::size_t first = 0, count = 0;
};
/// Specimens side by side: the same headings again and again. One group where there is one.
std::vector<Group> groups_of(const Table&);

struct Chosen {
  std::size_t column = 0;
  Unit unit;
};
struct Roles {
  Chosen force, displacement;
  std::optional<Chosen> time, diameter;
  std::optional<std::size_t> particle;
  bool diameter_is_radius = false;
};

/// InvalidInput where a column is missing, could be several, or has no unit; with the option to write, and,
/// where a unit is missing, what a plausible one would give.
Roles roles_of(const Sheet&, const Table&, const Group&, const ReadOptions&);

/// Every value the same: a channel that nothing is connected to.
bool is_dead(const Column&);

} // namespace platen::measure
