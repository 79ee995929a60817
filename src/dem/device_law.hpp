#pragma once
// A law as source text that stands on nothing: C++ for a processor, CUDA for an accelerator. For codes that
// take a force model as text.

#include "fit/law_card.hpp"

#include <string>

namespace platen::dem {

struct DeviceLaw {
  std::string text;       ///< tables, and `platen_contact(...)`
  double sizes_error = 0; ///< of the force of spheres of unlike radii, relative, largest; radii up to 6 to 1
  double wide_error = 0;  ///< and beyond
};

/// Tables of spheres of one material for nine ratios of their radii, linear between, and on a rigid plane.
/// Numbers are double. InvalidInput for a card of one radius alone.
DeviceLaw device_law(const fit::LawCard&);

struct EngineModel {
  std::string functions, model, use; ///< prerequisites, force model, lines of Python that hand them over
};

/// The law, with viscous damping and Coulomb friction on Mindlin's stiffness as in the plug-in for LAMMPS, as
/// a force model of DEM-Engine. `restitution`: of an elastic contact.
EngineModel engine_model(const fit::LawCard&, double restitution, double friction);

} // namespace platen::dem
