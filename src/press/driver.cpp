#include "press/driver.hpp"

#include "core/version.hpp"
#include "press/case_card.hpp"
#include "press/confined.hpp"
#include "press/snapshot.hpp"
#include "press/strength.hpp"
#include "press/yield_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace platen::press {
namespace {

/// A wanted force is met to this share.
constexpr double relative_force_tolerance = 1e-5;
/// Of the force that is left a step of unloading takes at most this share.
constexpr double unloading_share = 0.3;
/// A step of a branch is cut in halves at most so often.
constexpr int cuts_max = 12;

/// The curve of a case before its first point.
Curve begun_curve(const Case& c) {
  Curve curve;
  curve.radius_m = c.radius_m;
  curve.sigma_ref_Pa = material::reference_stress(c.material.model);
  curve.E_Pa = material::initial_E(c.material.model);
  curve.nu = material::initial_nu(c.material.model);
  if (const auto* metal = std::get_if<material::VonMises>(&c.material.model))
    if (const auto* hollomon = std::get_if<material::Hollomon>(&metal->hardening))
      curve.inverse_m = hollomon->inverse_m;
  if (std::holds_alternative<Local>(c.experiment))
    std::tie(curve.phi_deg, curve.sigma_c_Pa) = drucker_prager_strength(c.material.model);
  curve.experiment = name_of(c.experiment);
  curve.material = c.material.name;
  curve.version = std::string(core::version);
  curve.engine = core::engine;
  return curve;
}

/// Halts that differ by rounding are one: a step of nothing would be continued to anywhere.
bool same(double a, double b) { return std::abs(a - b) <= 1e-9 * std::min(std::abs(a), std::abs(b)); }

/// Where loading halts, ascending: each of both lists, and the end.
std::vector<double> halts(std::vector<double> some, const std::vector<double>& others, double end) {
  some.insert(some.end(), others.begin(), others.end());
  std::erase_if(some, [end](double x) { return !(x < end) || same(x, end); });
  std::sort(some.begin(), some.end());
  some.erase(std::unique(some.begin(), some.end(), same), some.end());
  some.push_back(end);
  return some;
}

bool wanted(const std::vector<double>& list, double x) {
  return std::any_of(list.begin(), list.end(), [x](double y) { return same(y, x) || y == x; });
}

template <fe::Element E> class Driver {
 public:
  Driver(const Case& c, const Plan<E>& plan_, const Progress& progress_, const Observer<E>& observer_)
      : press_case(c), progress(progress_), observer(observer_), stepper(c.material.model, c.radius_m, plan_),
        rule(stepper.plan.steps), path(stepper.plan.halts), motion(stepper.plan.motion),
        state(stepper.at_rest()) {
    result.curve = begun_curve(c);
  }

  Result operator()() {
    const auto start = std::chrono::steady_clock::now();
    try {
      load();
    } catch (const Stop&) { result.interrupted = true; } catch (const std::bad_alloc&) {
      if (result.curve.points.empty()) throw;
      result.out_of_memory = true;
      result.failure = stopped("the memory of this machine does not suffice");
    }
    result.flags = flags_of(stepper.solid(), state.points);
    observer.report(result);
    auto& points = result.curve.points;
    points.insert(points.end(), branches.begin(), branches.end());
    Statistics& s = result.statistics;
    const fe::PhaseTimes& times = stepper.response().times;
    s.material_s = times.material_s;
    s.assembly_s = times.assembly_s;
    s.factorisation_s = times.factorisation_s;
    s.solve_s = times.solve_s;
    s.elements = stepper.solid().elements();
    s.unknowns = static_cast<int>(state.x.size());
    s.local_continuations = stepper.response().counts.bracketed;
    s.total_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return std::move(result);
  }

 private:
  struct Stop {}; ///< the callback asked to stop

  void load() {
    const auto forces = halts(path.unload_from_N, path.fields_at_N, path.force_end_N);
    const auto times = halts(halts(path.unload_from, path.fields_at, path.end), motion.turns, path.end);
    auto force = forces.cbegin();
    auto time = times.cbegin();
    double step = rule.first;
    while (force != forces.cend() && time != times.cend()) {
      const double here = state.time;
      const double reach = std::min(step, std::max(rule.first, rule.relative_max * here));
      double next = here + reach;
      if (next > *time - 0.3 * reach) next = *time; // no sliver before a halt
      auto reached = take(state, next);
      if (!reached) {
        step = (next - here) / 2;
        if (step < rule.smallest) return fail();
        continue;
      }
      if (reached->row.force_N > *force * (1 + relative_force_tolerance)) {
        reached = meet(*force, *reached);
        if (!reached) return fail();
      }
      accept(*reached, Branch::loading, 0);
      step = std::min(std::max(step, next - here) * rule.growth, rule.largest);
      bool keep = false, unload = false;
      if (state.row.force_N >= *force * (1 - relative_force_tolerance)) {
        keep |= wanted(path.fields_at_N, *force);
        unload |= wanted(path.unload_from_N, *force++);
      }
      if (state.time >= *time) {
        keep |= wanted(path.fields_at, *time);
        unload |= wanted(path.unload_from, *time);
        if (wanted(motion.turns, *time++)) step = rule.first;
      }
      if (keep) picture();
      if (unload) branch();
    }
  }

  /// From a step that went beyond the force to one that meets it: secant in F^(2/3), in which Hertz is a
  /// line.
  std::optional<State<E>> meet(double force, const State<E>& beyond) {
    const auto height = [](double F) { return std::pow(std::max(F, 0.0), 2.0 / 3); };
    double low = state.time, F_low = state.row.force_N, high = beyond.time, F_high = beyond.row.force_N;
    for (int i = 0; i < 20; ++i) {
      const double share = (height(force) - height(F_low)) / (height(F_high) - height(F_low));
      const double next = low + share * (high - low);
      auto reached = take(state, next);
      if (!reached) return {};
      const double F = reached->row.force_N;
      if (std::abs(F - force) <= relative_force_tolerance * force) return reached;
      (F < force ? low : high) = next;
      (F < force ? F_low : F_high) = F;
    }
    why = fe::Cause::too_many_iterations;
    return {};
  }

  /// Unloads a copy of the loaded state until it separates; loads it again to where it came from if wanted.
  void branch() {
    const State<E> loaded = state;
    const double top = state.time, force = state.row.force_N, R = press_case.radius_m;
    ++branch_id;
    stepper.forget();
    // The first step by the elastic flat punch of the current radius, the others by the slope met.
    const double E_star = result.curve.E_Pa / (1 - result.curve.nu * result.curve.nu);
    double slope = E_star * 2 * std::max(state.row.contact_radius_m, 1e-3 * R) * R;
    branches.push_back(row(Branch::unloading, branch_id));
    int cuts = 0;
    while (state.row.force_N > rule.separated * force) {
      const double here = state.time, force_here = state.row.force_N;
      const double drop = std::min(force / rule.unloading, unloading_share * force_here);
      const auto reached = take(state, here - drop / slope / (1 << cuts));
      if (!reached) {
        if (++cuts < cuts_max) continue;
        break; // what was unloaded stays in the curve
      }
      cuts = std::max(0, cuts - 1);
      accept(*reached, Branch::unloading, branch_id);
      if (state.row.force_N < force_here)
        slope = std::max((force_here - state.row.force_N) / (here - state.time), 0.02 * slope);
    }
    if (path.reload) {
      const double whole = (top - state.time) / rule.unloading;
      double step = whole / 4;
      while (state.time < top) {
        const double here = state.time, next = here + step > top - 0.3 * step ? top : here + step;
        const auto reached = take(state, next);
        if (!reached) {
          step = (next - here) / 2;
          if (step < whole / (1 << cuts_max)) break;
          continue;
        }
        accept(*reached, Branch::reloading, branch_id);
        step = std::min(step * rule.growth, whole);
      }
    }
    state = loaded;
    stepper.forget();
  }

  std::optional<State<E>> take(const State<E>& from, double time) {
    Step<E> step = stepper(from, time);
    Statistics& s = result.statistics;
    s.iterations += step.report.iterations;
    s.smooth_steps += step.report.smooth();
    s.quadratic_steps += step.report.quadratic();
    why = step.report.cause;
    if (!step.report.converged()) {
      ++s.cuts;
      return {};
    }
    ++s.steps;
    return std::move(step.state);
  }

  void accept(State<E>& reached, Branch kind, int id) {
    state = std::move(reached);
    auto& rows = kind == Branch::loading ? result.curve.points : branches;
    rows.push_back(row(kind, id));
    if (kind == Branch::loading) {
      observer.look(stepper, state);
      fraction = std::max(state.row.force_N / path.force_end_N, state.time / path.end);
    }
    if (progress && !progress(fraction, rows.back())) throw Stop{};
  }
  void accept(const State<E>& reached, Branch kind, int id) {
    State<E> copy = reached;
    accept(copy, kind, id);
  }

  CurvePoint row(Branch branch, int id) const {
    CurvePoint point = state.row;
    point.branch = branch;
    point.branch_id = id;
    // Legs on which planes with ways of their own move apart are branches.
    for (std::size_t leg = 0; leg < motion.retreats.size(); ++leg)
      if (motion.retreats[leg] && state.time > (leg ? motion.turns[leg - 1] : 0) &&
          state.time <= motion.turns[leg]) {
        point.branch = Branch::unloading;
        point.branch_id = static_cast<int>(leg);
      }
    return point;
  }

  void picture() {
    if constexpr (std::is_same_v<E, fe::Quad>) {
      result.snapshots.push_back(snapshot(stepper, state, Branch::loading));
      if (std::holds_alternative<Local>(press_case.experiment))
        result.profiles.push_back(profile(stepper, state));
    } else result.spatial.push_back(snapshot(stepper, state, Branch::loading));
  }

  void fail() {
    result.failure =
        stopped(fmt::format("{}, also in steps of {:.0e}{}", fe::words(why), rule.smallest, limit_load()));
  }

  std::string stopped(std::string_view because) const {
    return fmt::format("stopped at {} = {:.5g}, F = {:.5g} N: {}",
                       motion.turns.empty() ? "delta_bar" : "a way of the planes of delta/R0", state.time,
                       state.row.force_N, because);
  }

  /// Whether the particle, not the iteration, is what gave way: it flows as a whole, or the force has had its
  /// peak.
  std::string limit_load() const {
    constexpr double flowing = 0.9; // of the volume
    double peak = 0;
    for (const CurvePoint& point : result.curve.points) peak = std::max(peak, point.force_N);
    if (state.row.zone_elastic < 1 - flowing || state.row.force_N < peak)
      return fmt::format("; {:.0f} % of the volume flows{}: the particle has come to its limit load",
                         100 * (1 - state.row.zone_elastic),
                         state.row.force_N < peak ? " and the force falls" : "");
    return std::holds_alternative<material::Dpc>(press_case.material.model)
               ? "; the failure line of dpc carries little where Lambda is small against Gamma: run the card "
                 "with "
                 "--model vmdc"
               : "";
  }

  const Case& press_case;
  const Progress& progress;
  const Observer<E>& observer;
  Stepper<E> stepper;
  const StepRule& rule;
  const Halts& path;
  const Motion& motion;
  State<E> state;
  Result result;
  std::vector<CurvePoint> branches;
  fe::Cause why = fe::Cause::none;
  int branch_id = 0;
  double fraction = 0;
};

} // namespace

template <fe::Element E>
Result drive(const Case& c, const Plan<E>& plan, const Progress& progress, const Observer<E>& observer) {
  return Driver<E>(c, plan, progress, observer)();
}
template Result drive(const Case&, const Plan<fe::Quad>&, const Progress&, const Observer<fe::Quad>&);
template Result drive(const Case&, const Plan<fe::Hexahedron>&, const Progress&,
                      const Observer<fe::Hexahedron>&);

Result press(const Case& c, const Progress& progress) {
  validate(c);
  return std::visit(
      [&]<class X>(const X& experiment) {
        if constexpr (std::is_same_v<X, Local>) {
          YieldWatch watch(experiment);
          const Observer<fe::Quad> observer{
              [&](const auto& stepper, const auto& state) { watch.look(stepper, state); },
              [&](Result& result) { watch.report(result); }};
          return drive(c, plan(experiment), progress, observer);
        } else return drive(c, plan(experiment), progress);
      },
      c.experiment);
}

Result press_in_space(const Case& c, const Progress& progress) {
  return drive(c, plan_in_space(std::get<Simple>(c.experiment)), progress);
}

} // namespace platen::press
