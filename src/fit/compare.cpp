#include "fit/compare.hpp"

#include "core/error.hpp"
#include "fit/samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace platen::fit {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double least_step = 0.05; // of the overlap
constexpr std::size_t secant = 4;   // steps; shorter ones see the scallops of a mesh

struct Branches {
  std::vector<const press::CurvePoint*> loading;
  std::vector<std::vector<const press::CurvePoint*>> unloading;
};

Branches branches_of(const press::Curve& curve, const std::string& name) {
  Branches b;
  int last = -1;
  for (const auto& p : curve.points) {
    if (p.branch == press::Branch::loading) {
      if (!b.loading.empty() && !(b.loading.back()->delta_m < p.delta_m))
        throw core::InvalidInput(
            fmt::format("{}: the loading branch does not ascend in delta_m: {:g} comes after {:g}", name,
                        p.delta_m, b.loading.back()->delta_m));
      b.loading.push_back(&p);
    } else if (p.branch == press::Branch::unloading) {
      if (p.branch_id != last) b.unloading.emplace_back();
      b.unloading.back().push_back(&p);
      last = p.branch_id;
    }
  }
  if (b.loading.size() < 8)
    throw core::InvalidInput(fmt::format(
        "{}: the loading branch has {} points; a comparison needs at least 8", name, b.loading.size()));
  return b;
}

/// Force of the loading branch, linear between its points, from 0 at 0.
struct LoadingBranch {
  std::vector<double> delta{0}, force{0}, radius{0}, work{0};

  explicit LoadingBranch(const Branches& b) {
    for (const auto* p : b.loading) {
      if (!(p->delta_m > 0)) continue;
      work.push_back(work.back() + (p->delta_m - delta.back()) * (p->force_N + force.back()) / 2);
      delta.push_back(p->delta_m);
      force.push_back(p->force_N);
      radius.push_back(p->contact_radius_m);
    }
  }
  double at(const std::vector<double>& y, double x) const {
    if (!(x <= delta.back() * (1 + 1e-9))) return nothing;
    const auto i = static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(std::upper_bound(delta.begin(), delta.end(), x) - delta.begin(), 1,
                                   static_cast<std::ptrdiff_t>(delta.size()) - 1));
    return y[i - 1] + (y[i] - y[i - 1]) * (x - delta[i - 1]) / (delta[i] - delta[i - 1]);
  }
};

/// Work that an unloading branch from `top` returns; not-a-number unless it comes down to (nearly) no force.
double returned(const std::vector<const press::CurvePoint*>& branch, double top, double F_top) {
  double x = top, F = F_top, sum = 0;
  for (const auto* p : branch) {
    sum += (x - p->delta_m) * (F + p->force_N) / 2;
    x = p->delta_m;
    F = p->force_N;
  }
  return F <= 0.02 * F_top ? sum : nothing;
}

/// Where the branch leaves the loading curve: its first point, or the loading point just above it.
double turning_of(const LoadingBranch& loading, const std::vector<const press::CurvePoint*>& branch) {
  const double first = branch.front()->delta_m;
  const auto above = std::lower_bound(loading.delta.begin(), loading.delta.end(), first * (1 - 1e-9));
  return above == loading.delta.end() ? first : *above;
}

double root_mean(double squares, double reference) {
  return reference > 0 ? std::sqrt(squares / reference) : nothing;
}

} // namespace

Reference reference_of(const press::Curve& curve, std::string name) {
  const Branches b = branches_of(curve, name);
  const LoadingBranch loading(b);
  Reference r;
  r.radius_m = curve.radius_m;
  r.trace.name = std::move(name);
  for (std::size_t i = 1; i < loading.delta.size(); ++i) {
    const double last = r.delta.empty() ? 0 : r.delta.back();
    const bool end = i + 1 == loading.delta.size();
    if (!end && loading.delta[i] - last < least_step * loading.delta[i]) continue;
    r.delta.push_back(loading.delta[i]);
    r.trace.force.push_back(loading.force[i]);
    r.trace.radius.push_back(loading.radius[i] > 0 ? loading.radius[i] : nothing);
  }
  for (const auto& branch : b.unloading) {
    const double top = turning_of(loading, branch);
    const double back = returned(branch, top, loading.at(loading.force, top));
    const double spent = loading.at(loading.work, top);
    if (!(back >= 0 && spent > 0)) continue;
    r.turning.push_back(top);
    r.spent.push_back(spent);
    r.trace.lost_work.push_back(r.spent.back() - back);
  }
  r.trace.in_range.assign(r.delta.size(), true);
  return r;
}

Trace trace_of(const law::Law& law, const Reference& reference, std::string name) {
  Trace t{std::move(name), {}, {}, {}, {}};
  for (double delta : reference.delta) {
    const law::Response now = law::evaluate(law, {}, delta);
    t.force.push_back(now.force);
    t.radius.push_back(now.contact_radius);
    t.in_range.push_back(now.in_range);
  }
  for (double delta : reference.turning) t.lost_work.push_back(law::evaluate(law, {}, delta).dissipated_work);
  return t;
}

Trace trace_of(const press::Curve& curve, const Reference& reference, std::string name) {
  const Branches b = branches_of(curve, name);
  const LoadingBranch loading(b);
  const double scale = curve.radius_m / reference.radius_m; // delta grows with R, F with R^2, work with R^3
  Trace t{std::move(name), {}, {}, {}, {}};
  for (double delta : reference.delta) {
    t.force.push_back(loading.at(loading.force, delta * scale) / (scale * scale));
    const double a = loading.at(loading.radius, delta * scale) / scale;
    t.radius.push_back(a > 0 ? a : nothing);
    t.in_range.push_back(std::isfinite(t.force.back()));
  }
  for (double delta : reference.turning) {
    double lost = nothing;
    for (const auto& branch : b.unloading) {
      const double top = turning_of(loading, branch);
      if (std::abs(top - delta * scale) > 0.01 * top) continue;
      lost = (loading.at(loading.work, top) - returned(branch, top, loading.at(loading.force, top))) /
             (scale * scale * scale);
    }
    t.lost_work.push_back(lost);
  }
  return t;
}

std::vector<Deviation> deviations(const Reference& reference, const std::vector<Trace>& traces, double low,
                                  double high) {
  const auto& x = reference.delta;
  const auto inside = [&](double delta) {
    return delta > low * reference.radius_m && delta <= high * reference.radius_m * (1 + 1e-9);
  };
  const std::vector<double> weight = trapezoid_weights(x, 0);
  std::vector<Deviation> result;
  for (const Trace& t : traces) {
    double F2 = 0, dF2 = 0, a2 = 0, da2 = 0, S2 = 0, dS2 = 0;
    std::size_t points = 0, valid = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (!inside(x[i])) continue;
      const auto square = [&](double v) { return weight[i] * v * v; };
      F2 += square(reference.trace.force[i]);
      dF2 += square(t.force[i] - reference.trace.force[i]);
      if (std::isfinite(reference.trace.radius[i])) {
        a2 += square(reference.trace.radius[i]);
        da2 += square(t.radius[i] - reference.trace.radius[i]);
      }
      if (i >= secant && inside(x[i - secant])) {
        const double h = x[i] - x[i - secant];
        const double S = (reference.trace.force[i] - reference.trace.force[i - secant]) / h;
        const double dS = (t.force[i] - t.force[i - secant]) / h - S;
        S2 += square(S);
        dS2 += square(dS);
      }
      ++points;
      valid += t.in_range[i];
    }
    Deviation d;
    d.force = root_mean(dF2, F2);
    d.radius = root_mean(da2, a2);
    d.stiffness = root_mean(dS2, S2);
    double lost = 0;
    int turns = 0;
    for (std::size_t i = 0; i < reference.turning.size(); ++i) {
      if (!inside(reference.turning[i])) continue;
      lost += std::abs(t.lost_work[i] - reference.trace.lost_work[i]) / reference.spent[i];
      ++turns;
    }
    d.lost_work = turns ? lost / turns : nothing;
    d.in_range = points ? static_cast<double>(valid) / static_cast<double>(points) : 0;
    result.push_back(d);
  }
  for (Deviation& d : result) {
    if (!std::isfinite(d.force)) continue;
    d.rank = 1;
    for (const Deviation& other : result) d.rank += other.force < d.force;
  }
  return result;
}

} // namespace platen::fit
