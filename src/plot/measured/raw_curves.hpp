#pragma once
// Force over travel as it was measured, in the colours of what the importer found: what pictures of
// measurements share.

#include "measure/specimen.hpp"
#include "measure/stages.hpp"

#include <string>
#include <vector>

namespace platen::plot {

/// A particle with what was found in it.
struct Staged {
  const measure::Specimen* specimen;
  const measure::Stages* stages;
};

/// For gnuplot: data blocks, and the axes and the plot command of a panel that shows them.
struct RawPanel {
  std::string data, commands;
};
RawPanel raw_panel(const std::vector<Staged>&);

/// A block $name of rows; one that is empty still has a point, as gnuplot wants it.
std::string data_block(const std::string& name, const std::string& rows);
/// What both panels of such a picture begin with.
std::string panel_style();

} // namespace platen::plot
