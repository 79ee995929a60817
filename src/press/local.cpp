#include "press/local.hpp"

#include "core/error.hpp"
#include "core/number.hpp"
#include "press/sphere_run.hpp"
#include "press/yield_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <tuple>

namespace platen::press {
namespace {

/// Growth of delta from a step to the next: the contact radius grows by half as much, about an edge.
constexpr double loading_growth = 1.08;
/// The first step presses a contact of this share of the smallest resolved radius.
constexpr double first_contact = 0.5;
/// A branch unloads in about this many steps, and ends below this share of the force it started from.
constexpr int unloading_steps = 30;
constexpr double separated = 1e-3;
/// A wanted force is met to this share.
constexpr double relative_force_tolerance = 1e-5;
constexpr int cuts_max = 12;

struct Stop {}; ///< the callback asked to stop

void check(const Case& c) {
  const auto refuse = [](const std::string& what) { throw core::InvalidInput(what); };
  if (!(c.force_max_N > 0)) refuse("force_max_N must be positive");
  if (!(c.delta_bar_max > 0 && c.delta_bar_max <= 0.5)) refuse("delta_bar_max must lie in (0, 0.5]");
  if (!(c.radius_m > 0)) refuse("radius_m must be positive");
  if (!(c.first_contact_bar >= 1e-4 && c.first_contact_bar <= 0.02))
    refuse("first_contact_bar must lie in [1e-4, 0.02]");
  if (c.edges < 8 || c.edges > 100) refuse("edges must lie in [8, 100]");
  for (const auto* list : {&c.unload_from_N, &c.fields_at_N})
    for (const double F : *list)
      if (!(F > 0 && F <= c.force_max_N)) refuse("forces of the path must lie in (0, force_max_N]");
  for (const auto* list : {&c.unload_from, &c.fields_at})
    for (const double x : *list)
      if (!(x > 0 && x <= c.delta_bar_max)) refuse("overlaps of the path must lie in (0, delta_bar_max]");
}

class LocalPress {
 public:
  LocalPress(const Case& c, const Progress& progress_)
      : press_case(c), progress(progress_), run(c), watch(c, run) {
    result.curve = begun_curve(c);
    std::tie(result.curve.phi_deg, result.curve.sigma_c_Pa) = drucker_prager_strength(c.material.model);
    forces = halts(c.unload_from_N, c.fields_at_N, c.force_max_N);
    overlaps = halts(c.unload_from, c.fields_at, c.delta_bar_max);
  }

  LocalResult operator()() {
    const auto start = std::chrono::steady_clock::now();
    try {
      load();
    } catch (const Stop&) { result.interrupted = true; }
    result.flags = run.flags();
    watch.report(result);
    auto& points = result.curve.points;
    points.insert(points.end(), branches.begin(), branches.end());
    result.statistics = run.statistics();
    result.statistics.total_s =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return std::move(result);
  }

 private:
  static bool wanted(const std::vector<double>& list, double x) {
    return std::find(list.begin(), list.end(), x) != list.end();
  }

  void load() {
    const double first = first_contact * press_case.first_contact_bar;
    double step = first * first;
    int cuts = 0;
    auto force = forces.cbegin(), overlap = overlaps.cbegin();
    while (force != forces.cend() && overlap != overlaps.cend()) {
      const SphereRun::State before = run.state();
      const double here = before.delta_bar;
      if (here > 0 && cuts == 0) step = here * (loading_growth - 1);
      if (!try_step(std::min(here + step, *overlap))) {
        if (++cuts == cuts_max) return fail(here);
        step /= 2;
        continue;
      }
      cuts = std::max(0, cuts - 1);
      if (run.row().force_N > *force * (1 + relative_force_tolerance) && !meet(*force, before))
        return fail(here);
      accept(Branch::loading, 0, result.curve.points);
      bool keep = false, unload = false;
      if (run.row().force_N >= *force * (1 - relative_force_tolerance)) {
        keep |= wanted(press_case.fields_at_N, *force);
        unload |= wanted(press_case.unload_from_N, *force++);
      }
      if (run.delta_bar() >= *overlap) {
        keep |= wanted(press_case.fields_at, *overlap);
        unload |= wanted(press_case.unload_from, *overlap++);
      }
      if (keep) {
        result.snapshots.push_back(run.snapshot(Branch::loading));
        result.profiles.push_back(profile());
      }
      if (unload) branch();
    }
  }

  /// From a step that went beyond the force to one that meets it: secant in F^(2/3), in which Hertz is a
  /// line.
  bool meet(double force, const SphereRun::State& before) {
    const auto height = [&](double F) { return std::pow(F, 2.0 / 3); };
    double low = before.delta_bar, F_low = before.row.force_N;
    double high = run.delta_bar(), F_high = run.row().force_N;
    for (int i = 0; i < 20; ++i) {
      const double share = (height(force) - height(F_low)) / (height(F_high) - height(F_low));
      const double next = low + share * (high - low);
      run.restore(before);
      if (!try_step(next)) return false;
      const double F = run.row().force_N;
      if (std::abs(F - force) <= relative_force_tolerance * force) return true;
      (F < force ? low : high) = next;
      (F < force ? F_low : F_high) = F;
    }
    return false;
  }

  void branch() {
    const SphereRun::State loaded = run.state();
    const double top = run.delta_bar(), force = run.row().force_N;
    const int id = ++branch_id;
    // The first step by the elastic flat punch of the current radius, the others by the slope met.
    const double E = result.curve.E_Pa, nu = result.curve.nu, R = press_case.radius_m;
    double slope = E / (1 - nu * nu) * 2 * run.row().contact_radius_m * R;
    branches.push_back(run.row(Branch::unloading, id));
    int cuts = 0;
    while (run.row().force_N > separated * force) {
      const double here = run.delta_bar(), force_here = run.row().force_N;
      const double drop = std::min(force / unloading_steps, 0.3 * force_here);
      if (!try_step(here - drop / slope / (1 << cuts))) {
        if (++cuts < cuts_max) continue;
        break; // what was unloaded stays in the curve
      }
      cuts = std::max(0, cuts - 1);
      accept(Branch::unloading, id, branches);
      if (run.row().force_N < force_here)
        slope = std::max((force_here - run.row().force_N) / (here - run.delta_bar()), 0.02 * slope);
    }
    if (press_case.reload) {
      const double whole = (top - run.delta_bar()) / unloading_steps;
      double step = whole / 4;
      while (run.delta_bar() < top) {
        const double here = run.delta_bar();
        const double next = here + step > top - 0.3 * step ? top : here + step;
        if (!try_step(next)) {
          step = (next - here) / 2;
          if (step < whole / (1 << cuts_max)) break;
          continue;
        }
        accept(Branch::reloading, id, branches);
        step = std::min(step * 1.5, whole);
      }
    }
    run.restore(loaded);
  }

  PressureProfile profile() const {
    PressureProfile p{run.row().force_N, run.row().contact_radius_m, {}};
    for (const auto& ring : run.plane().pressure_profile())
      p.points.push_back({(ring.inner + ring.outer) / 2 * press_case.radius_m, ring.pressure});
    return p;
  }

  bool try_step(double delta_bar) {
    const fe::StepReport report = run.advance(delta_bar);
    why = report.why;
    return report.converged;
  }

  void accept(Branch kind, int id, std::vector<CurvePoint>& into) {
    into.push_back(run.row(kind, id));
    if (kind == Branch::loading) {
      watch.look(run);
      last_fraction =
          std::max(run.row().force_N / press_case.force_max_N, run.delta_bar() / press_case.delta_bar_max);
    }
    if (progress && !progress(last_fraction, into.back())) throw Stop{};
  }

  void fail(double delta_bar) {
    result.failure =
        fmt::format("stopped at delta_bar = {:.5g}, F = {:.5g} N: {}", delta_bar, run.row().force_N, why);
  }

  const Case& press_case;
  const Progress& progress;
  SphereRun run;
  YieldWatch watch;
  LocalResult result;
  std::vector<double> forces, overlaps; ///< where loading halts
  std::vector<CurvePoint> branches;
  std::string why;
  int branch_id = 0;
  double last_fraction = 0;
};

} // namespace

LocalResult local(const Case& c, const Progress& progress) {
  check(c);
  return LocalPress(c, progress)();
}

std::string profile_name(const PressureProfile& p) {
  // A force is met to a share of 1e-5.
  const double force = *core::number_from(fmt::format("{:.4g}", p.force_N));
  return fmt::format("profile-{}.csv", core::number_text(force));
}

std::string profile_csv(const PressureProfile& p) {
  std::string text = fmt::format("# force_N = {}\n# contact_radius_m = {}\nradius_m,pressure_Pa\n",
                                 core::number_text(p.force_N), core::number_text(p.contact_radius_m));
  for (const auto& [r, pressure] : p.points)
    text += fmt::format("{},{}\n", core::number_text(r), core::number_text(pressure));
  return text;
}

} // namespace platen::press
