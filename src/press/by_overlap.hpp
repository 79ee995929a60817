#pragma once
// A press that goes by overlap: loads in steps, unloads copies of the loaded state.

#include "press/simple.hpp"
#include "press/sphere_run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

namespace platen::press {

/// The press of a Run: what is SphereRun to a simple press.
template <class Run> class PressByOverlap {
 public:
  PressByOverlap(const Case& c, const Progress& progress_) : press_case(c), progress(progress_), run(c) {
    result.curve = begun_curve(c);
    turns = run.turns();
    stops = halts(halts(c.unload_from, c.fields_at, c.delta_bar_max), turns, c.delta_bar_max);
  }

  typename Run::Result operator()() {
    const auto start = std::chrono::steady_clock::now();
    try {
      load();
    } catch (const Stop&) { result.interrupted = true; }
    result.flags = run.flags();
    auto& points = result.curve.points;
    points.insert(points.end(), branches.begin(), branches.end());
    result.statistics = run.statistics();
    result.statistics.total_s =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return std::move(result);
  }

 private:
  struct Stop {}; ///< the callback asked to stop

  /// A branch unloads in about this many steps, and ends below this share of the force it started from.
  static constexpr int unloading_steps = 24;
  static constexpr double separated = 2e-3;
  static constexpr StepRule rule = Run::steps;

  static bool wanted(const std::vector<double>& list, double delta_bar) {
    return std::find(list.begin(), list.end(), delta_bar) != list.end();
  }

  void load() {
    double step = rule.first;
    for (const double stop : stops) {
      while (run.delta_bar() < stop) {
        const double here = run.delta_bar();
        double next = here + std::min(step, std::max(rule.first, rule.relative_max * here));
        if (next > stop - 0.3 * step) next = stop; // no sliver before a stop
        if (!advance(next, Branch::loading, 0, result.curve.points)) {
          step = (next - here) / 2;
          if (step >= rule.smallest) continue;
          fail(here);
          return;
        }
        step = std::min(std::max(step, next - here) * rule.growth, rule.largest * press_case.step_max);
      }
      if (wanted(press_case.fields_at, stop)) run.keep(result, Branch::loading);
      if (wanted(press_case.unload_from, stop)) branch();
      if (wanted(turns, stop)) step = rule.first;
    }
  }

  /// Unloads a copy of the loaded state until it separates; loads it again to where it came from if wanted.
  void branch() {
    const typename Run::State loaded = run.state();
    const double top = run.delta_bar(), force = run.row().force_N;
    const int id = ++branch_id;
    // The first step by the elastic flat punch of the current radius, the others by the slope met.
    const double E = result.curve.E_Pa, nu = result.curve.nu, R = press_case.radius_m;
    double slope = E / (1 - nu * nu) * 2 * std::max(run.row().contact_radius_m, 1e-3 * R) * R;
    branches.push_back(run.row(Branch::unloading, id));
    int cuts = 0;
    while (run.row().force_N > separated * force) {
      const double here = run.delta_bar(), force_here = run.row().force_N;
      double step = force / unloading_steps / slope / (1 << cuts);
      if (force_here < 0.1 * force) step /= 4;
      if (!advance(here - step, Branch::unloading, id, branches)) {
        if (++cuts < 12) continue; // what was unloaded stays in the curve
        break;
      }
      cuts = std::max(0, cuts - 1);
      if (run.row().force_N < force_here)
        slope = std::max((force_here - run.row().force_N) / (here - run.delta_bar()), 0.02 * slope);
    }
    if (press_case.reload) {
      const double bottom = run.delta_bar();
      double step = (top - bottom) / unloading_steps;
      while (run.delta_bar() < top) {
        const double here = run.delta_bar();
        const double next = here + step > top - 0.3 * step ? top : here + step;
        if (!advance(next, Branch::reloading, id, branches)) {
          step = (next - here) / 2;
          if (step < rule.smallest) break;
          continue;
        }
        step = std::min(step * rule.growth, (top - bottom) / unloading_steps);
      }
    }
    run.restore(loaded);
  }

  bool advance(double delta_bar, Branch kind, int id, std::vector<CurvePoint>& into) {
    const fe::StepReport report = run.advance(delta_bar);
    if (!report.converged) {
      why = report.why;
      return false;
    }
    into.push_back(run.row(kind, id));
    if (progress && !progress(kind == Branch::loading ? delta_bar / press_case.delta_bar_max : last_fraction,
                              into.back()))
      throw Stop{};
    if (kind == Branch::loading) last_fraction = delta_bar / press_case.delta_bar_max;
    return true;
  }

  void fail(double delta_bar) {
    const bool own_way = run.row().delta_bar != delta_bar && delta_bar > 0; // of planes with a history each
    result.failure =
        fmt::format("stopped at {} = {:.5g}: {}, also in steps of {:.0e}",
                    own_way ? "a way of the planes of delta/R0" : "delta_bar", delta_bar, why, rule.smallest);
    *result.failure += limit_load();
  }

  /// Whether the particle, not the iteration, is what gave way: it flows as a whole, or the force has had its
  /// peak.
  std::string limit_load() const {
    constexpr double flowing = 0.9; // of the volume
    const CurvePoint& row = run.row();
    double peak = 0;
    for (const CurvePoint& point : result.curve.points) peak = std::max(peak, point.force_N);
    const bool dpc = std::holds_alternative<material::Dpc>(press_case.material.model);
    if (row.zone_elastic < 1 - flowing || row.force_N < peak)
      return fmt::format("; {:.0f} % of the volume flows{}: the particle has come to its limit load",
                         100 * (1 - row.zone_elastic), row.force_N < peak ? " and the force falls" : "");
    return dpc ? "; the failure line of dpc carries little where Lambda is small against Gamma: run the card "
                 "with "
                 "--model vmdc"
               : "";
  }

  const Case& press_case;
  const Progress& progress;
  Run run;
  typename Run::Result result;
  std::vector<double> stops, turns;
  std::vector<CurvePoint> branches;
  std::string why;
  int branch_id = 0;
  double last_fraction = 0;
};

} // namespace platen::press
