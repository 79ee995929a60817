#pragma once
// What a press gives.

#include "fe/hexahedron.hpp"
#include "fe/quad.hpp"
#include "press/curve.hpp"

#include <functional>
#include <span>

namespace platen::press {

using material::Zone;

/// The zone that most points are in; of equally many the later one, rather plastic than elastic.
Zone prevailing(std::span<const Zone>);

/// A picture of the deformed mesh: lengths in units of R0, element means. Of a section (r, z): the plane
/// above at z = 1 - delta_bar, the equator at z = 0, the axis at r = 0.
template <fe::Element E> struct SnapshotOf {
  using Mesh = typename E::Mesh;
  double delta_bar = 0; ///< of a triaxial press the way gone
  Branch branch = Branch::loading;
  std::array<double, 3> plane{}; ///< where the planes along x, y, z lie; 0: none
  std::vector<fe::Vector<Mesh::dim>> nodes, displacement;
  std::vector<std::array<int, Mesh::corners>> elements;
  std::vector<std::array<Zone, E::points>> zones; ///< at the Gauss points, in the order of the corners
  std::vector<typename E::Stress> stress;         ///< Cauchy, tension positive (Pa)
  std::vector<double> p, q;                       ///< tension positive (Pa)
  std::vector<double> rho_r;
  std::vector<double> phi; ///< state variable of the model
  /// Invariants of the plastic Hencky strain -ln(C_p^-1)/2: of the shape reached, not accumulated on the way.
  std::vector<double> plastic_strain_v, plastic_strain_q;
  std::vector<std::array<int, Mesh::face_corners>> surface; ///< on the sphere
  std::vector<std::array<double, 3>> pressure;    ///< per face of it: contact with the planes x, y, z (Pa)
  std::vector<std::array<fe::Vector3, 3>> copies; ///< of a wedge: matrices that map it onto the whole
};
using Snapshot = SnapshotOf<fe::Quad>;
using SpatialSnapshot = SnapshotOf<fe::Hexahedron>;

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
  double plastic_strain; ///< threshold of the norm of the plastic strain, sqrt(2/3 e:e)
  double force_N;
};

/// Seconds spent per phase, and counters, of one press.
struct Statistics {
  double material_s = 0, assembly_s = 0, factorisation_s = 0, solve_s = 0, total_s = 0;
  int steps = 0, iterations = 0, cuts = 0, elements = 0, unknowns = 0;
  long local_continuations = 0; ///< material updates that needed more than plain Newton
  int smooth_steps = 0;         ///< steps without change of contact or zone during their iterations
  int quadratic_steps = 0;      ///< smooth steps whose residuals fell quadratically
};

/// Of force and contact radius of the loading, relative, against the limit of fine meshes
/// (press/estimate.hpp).
struct ErrorEstimate {
  double force, radius;
  int elements, coarse_elements;
};

struct Result {
  Curve curve;
  std::vector<Snapshot> snapshots;      ///< of a section
  std::vector<SpatialSnapshot> spatial; ///< of a wedge
  Statistics statistics;
  std::vector<std::string> flags; ///< plain sentences: "relative density capped at 1 in ... of the volume"
  std::optional<std::string> failure; ///< set when the press stopped early: at which delta_bar, and why
  bool out_of_memory = false;         ///< that was why
  bool interrupted = false;           ///< the callback asked to stop
  std::optional<ErrorEstimate> error; ///< where it was asked for
  // Of the local press:
  std::optional<Onset> axis; ///< first yield within 0.1 a of the axis
  std::optional<Onset> edge; ///< of the free surface at the contact edge
  std::vector<PressureProfile> profiles;
  /// Where the plastic zone under the contact first reaches the free surface, for several thresholds of
  /// the plastic strain; absent where it did not.
  std::vector<BreakThrough> break_through;
};

/// Called after each converged step with the fraction done; returning false stops the press, which then
/// returns what it has.
using Progress = std::function<bool(double fraction, const CurvePoint&)>;

/// profile-F.csv, F in N: `# key = value` lines, then radius_m,pressure_Pa.
std::string profile_csv(const PressureProfile&);
std::string profile_name(const PressureProfile&);

} // namespace platen::press
