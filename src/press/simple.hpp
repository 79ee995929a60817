#pragma once
// Simple compression: a sphere between two rigid frictionless planes, or two equal spheres (ES section 4).

#include "material/plasticity.hpp"
#include "press/case.hpp"
#include "press/curve.hpp"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace platen::press {

using material::Zone;

/// A picture of the quarter section at one delta_bar: lengths in units of R0, the plane above at
/// z = 1 - delta_bar, the equator at z = 0, the axis at r = 0. Values are element means.
struct Snapshot {
  double delta_bar = 0;
  Branch branch = Branch::loading;
  std::vector<std::array<double, 2>> nodes; ///< current (r, z)
  std::vector<std::array<double, 2>> displacement;
  std::vector<std::array<int, 4>> quads;     ///< counter-clockwise
  std::vector<std::array<Zone, 4>> zones;    ///< at the four Gauss points, in the order of the corners
  std::vector<std::array<double, 4>> stress; ///< Cauchy: rr, zz, rz, tt, tension positive (Pa)
  std::vector<double> p, q;                  ///< tension positive (Pa)
  std::vector<double> rho_r;
  std::vector<double> phi; ///< state variable of the model
  /// Invariants of the plastic Hencky strain -ln(C_p^-1)/2: of the shape reached, not accumulated on the way.
  std::vector<double> plastic_strain_v, plastic_strain_q;
};

/// Seconds spent per phase, and counters, of one press.
struct Statistics {
  double material_s = 0, assembly_s = 0, factorisation_s = 0, solve_s = 0, total_s = 0;
  int steps = 0, iterations = 0, cuts = 0, elements = 0, unknowns = 0;
  long local_continuations = 0; ///< material updates that needed more than plain Newton
  int smooth_steps = 0;         ///< steps without change of contact or zone during their iterations
  int quadratic_steps = 0;      ///< smooth steps whose residuals fell quadratically
};

struct Result {
  Curve curve;
  std::vector<Snapshot> snapshots;
  Statistics statistics;
  std::vector<std::string> flags; ///< plain sentences: "relative density capped at 1 in ... of the volume"
  std::optional<std::string> failure; ///< set when the press stopped early: at which delta_bar, and why
  bool interrupted = false;           ///< the callback asked to stop
};

/// Called after each converged step with the fraction done; returning false stops the press, which then
/// returns what it has.
using Progress = std::function<bool(double fraction, const CurvePoint&)>;

/// Presses: loads to delta_bar_max; from each delta_bar of unload_from unloads a copy of the loaded state
/// until it separates, and loads it again where the case says so. Never throws ConvergenceError: what was
/// computed comes back with `failure` set. Throws core::InvalidInput for a case outside its range.
Result simple(const Case&, const Progress& = {});

} // namespace platen::press
