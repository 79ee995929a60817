#pragma once
// The machine itself gives way: what its frame, load cell and platens move under force, measured with nothing
// between them.

#include "measure/specimen.hpp"

#include <optional>
#include <string>
#include <vector>

namespace platen::measure {

/// Travel that is the machine's, over force: a straight line, or points where it bends.
struct Machine {
  double compliance_m_per_N = 0;
  std::vector<double> force_N, travel_m; ///< of a machine that bends; empty: the straight line
  std::string said; ///< where it comes from, for cards and messages; empty: none was given

  double travel(double force) const;
  double slope(double force) const; ///< d(travel)/d(force)
  bool given() const { return !said.empty(); }
};

/// From a file measured without a particle. InvalidInput where its force does not grow.
Machine empty_machine(const Measurement&);

/// Its compliance, or such a file, or neither: an empty name. InvalidInput.
Machine machine_of(std::optional<double> compliance_m_per_N, const std::string& empty_machine_file,
                   const ReadOptions&);

} // namespace platen::measure
