#pragma once
// The local press: two equal spheres, or a sphere on a rigid plane, at loads where the contact radius is a
// few per cent of the sphere's (Wang et al. section 3). The path goes by force or by overlap.
//
// One mesh serves all loads (fe/contact_grid.hpp). The sphere is whole: what its finite size adds to the
// approach is in delta_m, and taken out in hertz_delta_m, which laws that have Hertz's elastic limit are
// fitted to.

#include "press/simple.hpp"

#include <optional>

namespace platen::press {

/// Where and at which force the material first yields. Below yield stresses grow with the cube root of the
/// force (Hertz), so the force is extrapolated from the last step before it.
struct Onset {
  double force_N;
  double r_over_a, depth_over_a; ///< place, over the contact radius of that step
};

/// Contact pressure over the radius at one load.
struct PressureProfile {
  double force_N, contact_radius_m;
  std::vector<std::array<double, 2>> points; ///< radius in the middle of an edge (m), mean pressure (Pa)
};

/// Thresholds of the plastic strain sqrt(2/3 e:e).
inline constexpr std::array<double, 5> joining_strains = {1e-5, 1e-4, 2e-4, 5e-4, 1e-3};

struct BreakThrough {
  double plastic_strain; ///< threshold of the norm of the plastic strain
  double force_N;
};

struct LocalResult : Result {
  std::optional<Onset> axis; ///< first yield within 0.1 a of the axis
  std::optional<Onset> edge; ///< of the free surface at the contact edge
  std::vector<PressureProfile> profiles;
  /// Where the plastic zone under the contact first reaches the free surface, for several thresholds of
  /// the plastic strain; absent where it did not.
  std::vector<BreakThrough> break_through;
};

/// Loads to force_max_N or delta_bar_max, whichever is met first; from each force of unload_from_N and
/// overlap of unload_from unloads a copy of the loaded state until it separates, and loads it again to where
/// it came from where the case says so. Errors as simple().
LocalResult local(const Case&, const Progress& = {});

/// profile-F.csv, F in N: `# key = value` lines, then radius_m,pressure_Pa.
std::string profile_csv(const PressureProfile&);
std::string profile_name(const PressureProfile&);

} // namespace platen::press
