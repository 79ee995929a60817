#include "fit/pressed.hpp"

#include "core/error.hpp"
#include "core/number.hpp"
#include "core/sha256.hpp"
#include "fit/refine_unloading.hpp"
#include "fit/samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

namespace platen::fit {
namespace {

constexpr double force_wanted = 0.002, radius_wanted = 0.011;
constexpr double first_part = 1e-3; // of the largest overlap: below, a press has a handful of contact points

struct Points {
  std::vector<double> x, F, a;
};

Points loading_points(const press::Curve& curve) {
  Points p;
  const press::CurvePoint* end = press::loading_end(curve);
  for (const auto& point : curve.points) {
    if (point.branch != press::Branch::loading || !(point.F_bar > 0)) continue;
    if (!(point.delta_bar >= first_part * end->delta_bar)) continue;
    if (!p.x.empty() && !(point.delta_bar > p.x.back() * (1 + 1e-9))) continue;
    p.x.push_back(point.delta_bar);
    p.F.push_back(point.F_bar);
    p.a.push_back(point.contact_radius_m / curve.radius_m);
  }
  return p;
}

/// Work that a branch gives back over its largest force, in delta_bar; nothing where it ends under load.
std::optional<double> given_back(const press::Curve& curve, const UnloadingFit& f) {
  double work = 0, x = f.delta_bar_max, F = f.F_bar_max;
  for (const auto& point : curve.points) {
    if (point.branch_id != f.branch_id || point.branch != press::Branch::unloading) continue;
    work += (F + point.F_bar) / 2 * (x - point.delta_bar);
    x = point.delta_bar, F = point.F_bar;
  }
  if (F > 0.01 * f.F_bar_max) return {};
  return work / f.F_bar_max;
}

law::PressedMaterial at_knots(const press::Curve& curve, const Points& p, const std::set<std::size_t>& knots,
                              const UnloadingFits& unloading) {
  law::PressedMaterial m{curve.E_Pa, curve.nu, curve.sigma_ref_Pa, {}, {}, {}, {}, {}, {}};
  for (const std::size_t i : knots)
    m.delta_bar.push_back(p.x[i]), m.F_bar.push_back(p.F[i]), m.a_bar.push_back(p.a[i]);
  for (const auto& f : unloading.fits) {
    if (!m.unload_delta_bar.empty() && !(f.delta_bar_max > m.unload_delta_bar.back())) continue;
    m.unload_delta_bar.push_back(f.delta_bar_max);
    m.alpha.push_back(std::clamp(f.alpha, 1.0, 10.0));
    // The fit of (13) weighs the force; a law has to give back the right work.
    const double hertz = 4.0 / 3 * m.E / (1 - m.nu * m.nu) / (std::numbers::pi * m.sigma_ref);
    const auto back = given_back(curve, f);
    m.beta.push_back(back ? std::cbrt(std::pow(f.F_bar_max / hertz, 2)) / (*back * (1 + m.alpha.back()))
                          : f.beta);
  }
  refine_unloading(m);
  return m;
}

using Knots = std::set<std::size_t>;

/// How far the law through some points of a curve is from the others.
struct Missed {
  std::vector<double> x, u, F, a; ///< x, and the logarithms

  explicit Missed(const Points& p) : x(p.x) {
    for (std::size_t i = 0; i < x.size(); ++i)
      u.push_back(std::log(p.x[i])), F.push_back(std::log(p.F[i])), a.push_back(std::log(p.a[i]));
  }
  /// Over what is wanted, the largest, and where; below delta_bar = 0.005 it weighs less by `small`.
  struct Most {
    double miss = 0;
    std::size_t where = 0;
  };
  [[nodiscard]] Most of(const Knots& knots, double small) const {
    std::vector<double> ku, kF, ka;
    for (const std::size_t i : knots) ku.push_back(u[i]), kF.push_back(F[i]), ka.push_back(a[i]);
    const law::MonotoneCurve force(ku, kF), radius(ku, ka);
    Most most;
    for (std::size_t i = 0; i < u.size(); ++i) {
      const double miss = std::max(std::abs(force.value(u[i]) - F[i]) / force_wanted,
                                   std::abs(radius.value(u[i]) - a[i]) / radius_wanted) /
                          (x[i] < 0.005 ? small : 1);
      if (miss > most.miss) most = {miss, i};
    }
    return most;
  }
};

/// The knots that the curve needs beside the `first`: one more where the law misses it most. Where they are
/// too few for its ripple, that one takes the place of one which is missed less.
Knots grown_from(const Knots& first, const Missed& missed, double small) {
  Knots knots = first;
  auto now = missed.of(knots, small);
  while (now.miss > 1 && knots.size() < std::min(missed.x.size(), law::PressedMaterial::most_knots)) {
    knots.insert(now.where);
    now = missed.of(knots, small);
  }
  const int exchanges = missed.x.size() <= 1000 ? 40 : 0; // of more rows each takes long
  for (int i = 0; i < exchanges && now.miss > 1; ++i) {
    Knots more = knots, best;
    more.insert(now.where);
    auto least = now;
    for (const std::size_t k : knots) {
      if (first.contains(k)) continue;
      Knots without = more;
      without.erase(k);
      if (const auto most = missed.of(without, small); most.miss < least.miss)
        least = most, best = std::move(without);
    }
    if (best.empty()) break;
    knots = std::move(best), now = least;
  }
  return knots;
}

Knots choose_knots(const Points& p, const UnloadingFits& unloading) {
  const Missed missed(p);
  const std::size_t n = p.x.size();
  Knots first;
  for (std::size_t k = 0; k < 6; ++k) first.insert(k * (n - 1) / 5);
  for (const auto& f : unloading.fits) // there unloading is known
    first.insert(std::min<std::size_t>(
        n - 1, static_cast<std::size_t>(
                   std::lower_bound(p.x.begin(), p.x.end(), f.delta_bar_max * (1 - 1e-9)) - p.x.begin())));
  Knots best = grown_from(first, missed, 1);
  if (missed.of(best, 1).miss <= 1) return best;
  // Too few: small overlaps may be missed by more, if that helps the others.
  for (const double small : {2.0, 5.0}) {
    Knots knots = grown_from(first, missed, small);
    if (missed.of(knots, law::infinity).miss < missed.of(best, law::infinity).miss) best = std::move(knots);
  }
  return best;
}

/// Of every row of loading, so that one without force tells.
double r_squared_of(const press::Curve& curve, const law::Law& law, double per_F) {
  Samples rows;
  std::vector<double> of_law;
  for (const auto& point : curve.points) {
    if (point.branch != press::Branch::loading || !(point.delta_bar > 0)) continue;
    if (rows.size() && !(point.delta_bar > rows.delta_bar.back())) continue;
    rows.delta_bar.push_back(point.delta_bar);
    rows.F_bar.push_back(point.F_bar);
    of_law.push_back(law::evaluate(law, {}, point.delta_bar).force * per_F);
  }
  rows.weight = trapezoid_weights(rows.delta_bar, 0);
  return r_squared(rows, of_law);
}

/// The law against the curve, on its loading and along its unloading branches.
PressedErrors errors_of(const press::Curve& curve, const Points& p, const law::PressedMaterial& m,
                        bool radius_measured) {
  const double R = 1, per_F = 1 / (std::numbers::pi * m.sigma_ref);
  const law::Law law = law::tabulate(law::prepare_on_rigid_plane(m, R));
  PressedErrors e;
  const std::vector<double> weight = trapezoid_weights(p.x, 0);
  double F2 = 0, dF2 = 0, a2 = 0, da2 = 0;
  for (std::size_t i = 0; i < p.x.size(); ++i) {
    const law::Response now = law::evaluate(law, {}, p.x[i]);
    const double F = now.force * per_F;
    F2 += weight[i] * p.F[i] * p.F[i];
    dF2 += weight[i] * (F - p.F[i]) * (F - p.F[i]);
    if (p.x[i] >= 0.005) e.worst = std::max(e.worst, std::abs(F / p.F[i] - 1));
    a2 += weight[i] * p.a[i] * p.a[i];
    da2 += weight[i] * (now.contact_radius - p.a[i]) * (now.contact_radius - p.a[i]);
  }
  e.relative_l2 = std::sqrt(dF2 / F2);
  e.r_squared = r_squared_of(curve, law, per_F);
  if (radius_measured) e.radius = std::sqrt(da2 / a2);
  // Work given back by each branch, by the trapezoid rule on its own points for both.
  std::set<int> ids;
  for (const auto& point : curve.points)
    if (point.branch == press::Branch::unloading) ids.insert(point.branch_id);
  for (const int id : ids) {
    double top = 0, here = 0, there = 0, last_x = 0, last_F = 0, last_law = 0;
    bool first = true;
    for (const auto& point : curve.points) {
      if (point.branch_id != id || point.branch != press::Branch::unloading) continue;
      if (first) {
        const auto above = std::lower_bound(p.x.begin(), p.x.end(), point.delta_bar * (1 - 1e-9));
        if (above == p.x.end()) break;
        top = *above;
        last_x = top;
        last_F = p.F[static_cast<std::size_t>(above - p.x.begin())];
        last_law = law::evaluate(law, {}, top).force * per_F;
        first = false;
      }
      const double F = law::evaluate(law, {top, top}, point.delta_bar).force * per_F;
      here += (last_F + point.F_bar) / 2 * (last_x - point.delta_bar);
      there += (last_law + F) / 2 * (last_x - point.delta_bar);
      last_x = point.delta_bar, last_F = point.F_bar, last_law = F;
    }
    if (here > 0) e.unload_work = std::max(e.unload_work, std::abs(there / here - 1));
  }
  return e;
}

std::string list_of(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += fmt::format("{}{:.7g}", text.empty() ? "" : ",", number);
  return text;
}

} // namespace

PressedFit fit_pressed(const press::Curve& curve, const UnloadingFits& unloading) {
  if (!(curve.E_Pa > 0) || !(curve.sigma_ref_Pa > 0))
    throw core::InvalidInput(
        "the law pressed needs Young's modulus, Poisson's ratio and a reference stress, which the "
        "curve does not say; give --E_Pa, --nu and --sigma_ref_Pa");
  Points p = loading_points(curve);
  if (p.x.size() < 8)
    throw core::InvalidInput(fmt::format(
        "the law pressed needs 8 points of loading with a force, and the curve has {}", p.x.size()));
  refuse_beyond_squares(p.F);
  PressedFit fit;
  const std::vector<double> F = growing(p.F, 1e-6);
  double square = 0;
  for (std::size_t i = 0; i < F.size(); ++i)
    square += std::pow(F[i] / p.F[i] - 1, 2) / static_cast<double>(F.size());
  fit.residual = std::sqrt(square) > 1e-5 ? std::sqrt(square) : 0;
  const Points as_given = p;
  p.F = F;
  fit.radius_measured = std::ranges::all_of(p.a, [](double a) { return a > 0; });
  if (!fit.radius_measured) {
    const double hertz =
        4.0 / 3 * curve.E_Pa / (1 - curve.nu * curve.nu) / (std::numbers::pi * curve.sigma_ref_Pa);
    for (std::size_t i = 0; i < p.x.size(); ++i)
      p.a[i] = std::sqrt(p.x[i] * (2 - std::min(1.0, std::cbrt(std::pow(p.F[i] / hertz, 2)) / p.x[i])));
  }
  p.a = growing(p.a, 1e-6);
  fit.material = at_knots(curve, p, choose_knots(p, unloading), unloading);
  Points given = as_given;
  if (!fit.radius_measured) given.a = p.a;
  try {
    fit.errors = errors_of(curve, given, fit.material, fit.radius_measured);
  } catch (const law::BadParameter& error) { throw core::InvalidInput(error.what()); }
  return fit;
}

LawCard law_card(const press::Curve& curve, const PressedFit& fit, std::string_view curve_text) {
  LawCard card;
  card.law = "pressed";
  const auto& m = fit.material;
  card.parameters = {{"sigma_ref_Pa", core::number_text(m.sigma_ref)},
                     {"E_Pa", core::number_text(m.E)},
                     {"nu", core::number_text(m.nu)},
                     {"delta_bar", list_of(m.delta_bar)},
                     {"F_bar", list_of(m.F_bar)},
                     {"a_bar", list_of(m.a_bar)}};
  if (!m.alpha.empty()) {
    card.parameters["unload_delta_bar"] = list_of(m.unload_delta_bar);
    card.parameters["alpha"] = list_of(m.alpha);
    card.parameters["beta"] = list_of(m.beta);
  }
  card.delta_bar = {0, m.delta_bar.back()};
  card.errors = {{"relative_l2", fit.errors.relative_l2}, {"worst", fit.errors.worst}};
  if (fit.radius_measured) card.errors.emplace_back("radius_l2", fit.errors.radius);
  if (!m.alpha.empty()) card.errors.emplace_back("unload_work", fit.errors.unload_work);
  if (fit.residual > 0) card.errors.emplace_back("smoothed", fit.residual);
  card.provenance = {
      {"material", curve.material}, {"curve_sha256", core::sha256(curve_text)}, {"engine", curve.engine}};
  if (!fit.radius_measured)
    card.provenance.emplace_back("contact_radius", std::string("not measured: from the force"));
  return card;
}

} // namespace platen::fit
