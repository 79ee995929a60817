#pragma once
// Which materials to press next: those of which a surrogate is least sure.

#include "surrogate/surrogate.hpp"

#include <vector>

namespace platen::surrogate {

struct Refined {
  std::vector<std::size_t> chosen; ///< of the candidates, in the order in which they were chosen
  std::vector<double> largest; ///< expected error of the least certain candidate before each, and after all
};

/// One after the other the candidate whose curve is expected to be furthest off (Prediction::expected, at the
/// end of the curve), as if those before were pressed: what a process does not know there does not depend on
/// what a press will say. Lengths, and what repeats of a press differ by, stay. Until all are expected to be
/// less than `target` off, `most` are chosen, or no press makes anything surer. Presses are of the finest
/// mesh.
Refined refine(const Surrogate&, const std::vector<Description>& candidates, double target, std::size_t most);

} // namespace platen::surrogate
