#pragma once
// Sections through the particle side by side: what zone maps and field maps share.

#include "plot/regions.hpp"
#include "plot/scene.hpp"
#include "press/result.hpp"

#include <functional>
#include <string>
#include <vector>

namespace platen::plot {

/// Colour index of each quarter element of one snapshot.
using SnapshotColour = std::function<Colour(const press::Snapshot&)>;

struct Sections {
  Scene scene;
  double legend_top = 0; ///< free from here down; extend scene.height as needed
  double margin = 0;
};

/// Throws InvalidInput for no snapshots, or ones whose arrays do not fit together.
void check(const std::vector<press::Snapshot>&);

/// Title, panels with the rigid planes and their delta_bar, scale bar of R0. The snapshots are checked first.
Sections sections(const std::vector<press::Snapshot>&, const std::string& title, const SnapshotColour&,
                  const std::vector<std::string>& palette);

} // namespace platen::plot
