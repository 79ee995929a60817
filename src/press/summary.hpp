#pragma once
// summary.json: what was pressed, by what, how it went.

#include "press/case.hpp"
#include "press/result.hpp"

#include <string>

namespace platen::press {

/// The resolved input, version and engine, the last point, the largest tension and where it reaches the
/// tensile strength of the card, statistics, flags and, when the press stopped early, where and why. Of a
/// local press first yield and break-through; of a confined one the last contact of each plane, the cell, the
/// mesh.
std::string summary_json(const Case&, const Result&);

} // namespace platen::press
