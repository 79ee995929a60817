#pragma once
// The simple press in CalculiX: axisymmetric, the same mesh as ours, von Mises, perfectly plastic.

#include "fe/quarter_disc.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace platen::bench {

/// Lengths in units of R0, stresses in units of sigma_y.
struct PressOfPeer {
  double E_bar = 100; ///< E/sigma_y
  double nu = 0.3;
  double step_max = 0.001;       ///< largest increment of delta_bar
  std::vector<double> delta_bar; ///< where forces are compared, ascending; the last one is the end
};

/// The input deck. The plane stands still at z = 1, and the equator moves towards it.
std::string calculix_deck(const fe::SectionMesh&, const PressOfPeer&);

struct PeerCurve {
  std::vector<double> F_bar; ///< F/(pi R0^2 sigma_y) at each delta_bar
  double cpu_s = 0;
  int increments = 0, iterations = 0;
};

/// Runs `ccx` in `folder` on one thread. IoError where it is missing or did not get to the end.
PeerCurve run_calculix(const fe::SectionMesh&, const PressOfPeer&, const std::filesystem::path& folder);

} // namespace platen::bench
