#pragma once
// How far a press is from the limit of fine meshes: by pressing once more on a coarser one.

#include "press/press.hpp"

namespace platen::press {

/// Half as many elements (local: half as many edges under the contact), loading alone.
Case coarser(const Case&);

/// The largest relative difference in force and contact radius between the loading of both meshes, from a
/// twentieth of the path on, continued to the limit as if the error went with the square of the element size:
/// that is what the deviation from independent codes does (docs/explanation/discretisation.md). Scallops of
/// both meshes add up in it, so it is rather too large. Empty where the coarser press stopped early.
std::optional<ErrorEstimate> estimate_error(const Case&, const Result& fine, const Progress& = {});

} // namespace platen::press
