#pragma once
// `platen derive --law wang`: the local press and the fit of its law.

#include "material/card.hpp"

#include <optional>
#include <string>
#include <vector>

namespace platen::app {

struct LocalDerivation {
  material::Material material;
  std::string folder;
  double radius_m = 1e-3;
  std::optional<double> delta_bar_max, force_max_N; ///< neither: five times the overlap of first yield
  std::string unload_from; ///< delta/R0: "1e-5,2e-5"; "none"; empty: four branches up to the end
  bool json = false;
};

/// Presses, fits, writes law card and pictures. Throws core::InvalidInput where first yield is not that of a
/// small contact, or the material has no such strength as the law needs.
void derive_local(const LocalDerivation&);

/// Overlaps to unload from: "0.1,0.3", or "none"; nothing of an empty text. Throws core::InvalidInput.
std::optional<std::vector<double>> unloading_list(const std::string& text);

} // namespace platen::app
