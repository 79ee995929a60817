#pragma once
// Newton's method with a line search, for any system that can say its residual and solve with its tangent.

#include "material/plasticity.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <span>
#include <string_view>
#include <vector>

namespace platen::fe {

struct NewtonSettings {
  double relative_residual_tolerance = 1e-4; ///< of the free unknowns, relative to the reactions
  int iterations_max = 25;
};

/// Why a solution was not found.
enum class Cause {
  none,
  inverted_element,
  refused_material,
  diverged,
  too_many_iterations,
  singular,
  stalled
};
std::string_view words(Cause);

/// A system at one iterate.
struct Iterate {
  std::vector<double> force; ///< residual, per unknown
  double relative = 0;       ///< its size
  std::vector<char> touching;
  std::vector<material::Zone> zones;
};

/// One equilibrium.
struct StepReport {
  Cause cause = Cause::none; ///< none: it converged
  int iterations = 0;
  std::vector<double> residuals; ///< relative, one an iterate
  bool contact_changed = false;  ///< of any contact point, after the first iterate
  bool zone_changed = false;     ///< of any Gauss point, after the first iterate

  bool converged() const { return cause == Cause::none; }
  /// Converged in two iterations or more without a change of contact or zone: no kink was crossed.
  bool smooth() const { return converged() && !contact_changed && !zone_changed && residuals.size() >= 3; }
  /// Smooth, and r_2/r_0 <= 100 (r_1/r_0)^2, down to r_2 = 1e-12.
  bool quadratic() const {
    if (!smooth()) return false;
    const double first = residuals[1] / residuals[0];
    return residuals[2] <= std::max(100 * first * first * residuals[0], 1e-12);
  }
};

/// evaluate: residual at x, or why there is none. linearise: takes the tangent there. solve: replaces the
/// right-hand side by the solution.
template <class S>
concept System = requires(S& system, const std::vector<double>& x, Iterate& iterate, std::span<double> rhs) {
  { system.evaluate(x, iterate) } -> std::same_as<Cause>;
  { system.linearise(iterate) } -> std::same_as<Cause>;
  { system.solve(rhs) } -> std::same_as<Cause>;
};

/// The residual may grow while zones and contacts settle, but not beyond this many reactions; a residual of
/// the size of the reactions is one of no equilibrium at all.
inline constexpr double diverged = 1e3;
/// Line search: the work of the residual on the correction may overshoot by this share of what it was
/// (Matthies & Strang 1979 ask 0.5). How often the correction is shortened.
inline constexpr double work_left = 0.5;
inline constexpr int searches_max = 3;

/// Solves from the guess in x, with a line search where the work of the residual does not fall. Where the
/// report says that it did not converge, x is unspecified.
template <System S> StepReport newton(S& system, const NewtonSettings& settings, std::vector<double>& x) {
  StepReport report;
  const auto give_up = [&](Cause cause) {
    report.cause = cause;
    return report;
  };
  Iterate now, before;
  std::vector<double> correction(x.size());
  const auto work = [&] {
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) sum -= correction[i] * now.force[i];
    return sum;
  };
  double work_0 = 0; // of the residual on the correction, before it
  for (;; ++report.iterations) {
    Cause cause = system.evaluate(x, now);
    double fraction = 1;
    for (int search = 0; report.iterations > 0 && search < searches_max; ++search) {
      const bool failed = cause != Cause::none;
      const double left = failed ? 0 : work();
      // What is left of the other sign: it went too far. More than there was: the system softens on the way.
      if (!failed && left >= -work_left * std::abs(work_0) && left <= std::abs(work_0)) break;
      const double next =
          fraction * (failed || left > 0 ? 0.5 : std::clamp(work_0 / (work_0 - left), 0.2, 0.8));
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += (next - fraction) * correction[i];
      fraction = next;
      cause = system.evaluate(x, now);
    }
    if (cause != Cause::none) return give_up(cause);
    if (report.iterations > 0) {
      report.zone_changed |= now.zones != before.zones;
      report.contact_changed |= now.touching != before.touching;
    }
    report.residuals.push_back(now.relative);
    if (now.relative <= settings.relative_residual_tolerance) return report;
    if (now.relative > diverged && report.iterations > 3) return give_up(Cause::diverged);
    if (report.iterations == settings.iterations_max) return give_up(Cause::too_many_iterations);

    if (const Cause c = system.linearise(now); c != Cause::none) return give_up(c);
    for (std::size_t i = 0; i < x.size(); ++i) correction[i] = -now.force[i];
    if (const Cause c = system.solve(correction); c != Cause::none) return give_up(c);
    work_0 = work();
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += correction[i];
    std::swap(before.zones, now.zones);
    std::swap(before.touching, now.touching);
  }
}

} // namespace platen::fe
