#pragma once
// A scalar field over the section of the particle.

#include "press/result.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace platen::plot {

/// What to show: one value an element, and the words beside the colour bar ("relative density", "q/σ_ref").
struct Field {
  std::string name;
  std::function<std::vector<double>(const press::Snapshot&)> values;
};

Field relative_density();
/// q/sigma_ref, p/sigma_ref (tension positive).
Field deviatoric_stress(double sigma_ref_Pa);
Field mean_stress(double sigma_ref_Pa);

/// One panel a snapshot in a perceptually uniform colour map (viridis) with one colour bar for all panels.
/// Values are averaged to the nodes and interpolated to quarter elements. Throws InvalidInput, IoError.
void field_map(const std::vector<press::Snapshot>& snapshots, const Field& field, const std::string& title,
               const std::filesystem::path& file);

} // namespace platen::plot
