#pragma once
// How far laws and curves are from a reference curve, range of overlap by range of overlap.

#include "platen/law/catalogue.hpp"
#include "press/curve.hpp"

#include <string>
#include <vector>

namespace platen::fit {

/// What a law or a curve says at the overlaps of the reference. Not-a-number: nothing is said there.
struct Trace {
  std::string name;
  std::vector<double> force;     ///< N
  std::vector<double> radius;    ///< contact radius, m
  std::vector<bool> in_range;    ///< inside the law's own validity
  std::vector<double> lost_work; ///< J, at the turning points of the reference
};

/// A reference curve as it is compared with: its loading branch thinned to steps of at least a twentieth of
/// the overlap.
struct Reference {
  std::vector<double> delta; ///< m, ascending
  Trace trace;
  std::vector<double> turning; ///< m: overlaps from which the curve unloads to zero force
  std::vector<double> spent;   ///< J: work spent up to there
  double radius_m = 0;
};

/// Throws core::InvalidInput where the loading branch is too short or not ascending.
Reference reference_of(const press::Curve&, std::string name);

/// A law, for a sphere of the reference's radius on a rigid plane.
Trace trace_of(const law::Law&, const Reference&, std::string name);
/// Another curve, interpolated; its own radius makes overlaps and forces comparable as delta/R and F/R^2.
Trace trace_of(const press::Curve&, const Reference&, std::string name);

/// Relative L2 deviations (trapezoid weights in delta) over one range; not-a-number where there is nothing to
/// compare.
struct Deviation {
  double force = 0, radius = 0;
  double stiffness = 0; ///< of secants over a fifth of the overlap: shorter ones see the scallops of a mesh
  double lost_work = 0; ///< mean over turning points of |difference|/work spent
  double in_range = 0;  ///< fraction of the points inside the law's validity
  int rank = 0;         ///< by force, 1 is nearest; 0: says nothing there
};

/// One for each trace, over low < delta/R <= high.
std::vector<Deviation> deviations(const Reference&, const std::vector<Trace>&, double low, double high);

} // namespace platen::fit
