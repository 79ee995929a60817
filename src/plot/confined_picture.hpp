#pragma once
// What a confined press shows: its contacts, the deformed particle, the pressure on its faces.

#include "press/result.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace platen::plot {

/// Mean pressure, radius and force of each plane's contact over delta/R0 of the plane along z.
void contacts_picture(const press::Curve&, const std::filesystem::path&);

/// The particle with an octant taken out, coloured by the plastic strain; one panel a snapshot. SVG or PNG by
/// file ending. Throws InvalidInput, IoError.
void particle_picture(const std::vector<press::SpatialSnapshot>&, const std::string& title,
                      const std::filesystem::path&);

/// The contact pressure over each plane, in units of sigma_ref; one column a snapshot.
void faces_picture(const std::vector<press::SpatialSnapshot>&, double sigma_ref_Pa, const std::string& title,
                   const std::filesystem::path&);

} // namespace platen::plot
