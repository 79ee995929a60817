#pragma once
// summary.json: what was pressed, by what, how it went.

#include "press/case.hpp"
#include "press/confined.hpp"
#include "press/local.hpp"

#include <string>

namespace platen::press {

/// The resolved input, version and engine, the last point, the largest tension and where it reaches the
/// tensile strength of the card, statistics, flags and, when the press stopped early, where and why.
std::string summary_json(const Case&, const Result&);
/// The same with first yield and break-through.
std::string summary_json(const Case&, const LocalResult&);
/// The same with the last contact of each plane, the cell, and the mesh.
std::string summary_json(const Case&, const ConfinedResult&);

} // namespace platen::press
