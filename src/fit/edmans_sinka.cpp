#include "fit/edmans_sinka.hpp"

#include "core/error.hpp"
#include "fit/edmans_sinka_search.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace platen::fit {

namespace {

using law::EdmansSinkaVariant;

constexpr std::array<std::pair<std::string_view, EdmansSinkaVariant>, 3> variants = {
    {{"published", EdmansSinkaVariant::published},
     {"c1", EdmansSinkaVariant::c1},
     {"hertz-like", EdmansSinkaVariant::hertz_like}}};

EdmansSinkaVariant variant_named(std::string_view name) {
  for (const auto& [known, variant] : variants)
    if (name == known) return variant;
  throw core::InvalidInput(fmt::format("edmans-sinka has no variant '{}' to fit; there are {}", name,
                                       fmt::join(edmans_sinka_variants(), ", ")));
}

/// One end of an interval: where the error, the other parameters fitted anew, has grown by 10 %.
double interval_end(const EdmansSinkaSearch& search, const EdmansSinkaSearch::Found& best,
                    std::size_t parameter, double direction) {
  constexpr double growth = 1.1, relative_interval_tolerance = 1e-3;
  constexpr double negligible = 1e-9; // an exact fit leaves no room
  const double limit = growth * best.relative_l2, value = best.parameters[parameter];
  if (best.relative_l2 < negligible) return value;
  const double bound = direction < 0 ? search.bounds().low[parameter] : search.bounds().high[parameter];
  double inside = value, outside = value;
  EdmansSinkaParameters near = best.parameters;
  // outwards until the error is too large; 40 doublings are past any use of the parameter
  for (int doubling = 0; doubling < 40; ++doubling) {
    const double step = 0.01 * value * std::exp2(doubling);
    outside = direction < 0 ? std::max(bound, value - step) : std::min(bound, value + step);
    const auto found = search.best_with(parameter, outside, near);
    if (found.relative_l2 > limit) break;
    if (outside == bound || doubling == 39) return outside;
    inside = outside;
    near = found.parameters;
  }
  while (std::abs(outside - inside) > relative_interval_tolerance * std::abs(outside - value)) {
    const double middle = (inside + outside) / 2;
    const auto found = search.best_with(parameter, middle, near);
    if (found.relative_l2 > limit) {
      outside = middle;
    } else {
      inside = middle;
      near = found.parameters;
    }
  }
  return inside;
}

EdmansSinkaFit fit(const Samples& samples, EdmansSinkaVariant variant) {
  const EdmansSinkaSearch search(samples, variant);
  const auto best = search.best();
  EdmansSinkaFit result;
  result.variant = variant;
  std::tie(result.k, result.delta_t, result.a) = std::tuple_cat(best.parameters);
  std::array<Interval*, 3> intervals = {&result.k_interval, &result.delta_t_interval, &result.a_interval};
  for (std::size_t i = 0; i < 3; ++i)
    *intervals[i] = {interval_end(search, best, i, -1), interval_end(search, best, i, +1)};
  const std::vector<double> F_bar_law = result.F_bar(samples.delta_bar);
  result.errors = errors(samples, F_bar_law);
  result.r_squared = r_squared(samples, F_bar_law);
  result.delta_bar_max = samples.delta_bar.back();
  result.points = samples.size();
  return result;
}

std::string verdict(const std::vector<EdmansSinkaFit>& fits) {
  std::string result = fmt::format("{} fits best: relative L2 {:.2f} %", name_of(fits.front().variant),
                                   100 * fits.front().errors.relative_l2);
  for (std::size_t i = 1; i < fits.size(); ++i)
    result += fmt::format(", {} {:.2f} %", name_of(fits[i].variant), 100 * fits[i].errors.relative_l2);
  return result;
}

} // namespace

std::vector<double> EdmansSinkaFit::F_bar(const std::vector<double>& delta_bar) const {
  const auto law = curve();
  std::vector<double> result;
  for (const double x : delta_bar) result.push_back(law.F_bar(x));
  return result;
}

std::vector<std::string_view> EdmansSinkaFit::on_bound() const {
  constexpr double least_a = 1.1e-3, most_a = 49.9; // the search's ends, docs/explanation/edmans-sinka-fit.md
  return a < least_a || a > most_a ? std::vector<std::string_view>{"a"} : std::vector<std::string_view>{};
}

std::vector<std::string_view> edmans_sinka_variants() {
  std::vector<std::string_view> names;
  for (const auto& [name, variant] : variants) names.push_back(name);
  return names;
}

std::string_view name_of(EdmansSinkaVariant wanted) {
  return std::ranges::find(variants, wanted, &std::remove_cvref_t<decltype(variants[0])>::second)->first;
}

EdmansSinkaFit fit_edmans_sinka(const press::Curve& curve, std::string_view variant) {
  return fit(loading_samples(curve), variant_named(variant));
}

EdmansSinkaComparison fit_best(const press::Curve& curve) {
  const Samples samples = loading_samples(curve);
  EdmansSinkaComparison result;
  for (const auto& [name, variant] : variants) result.fits.push_back(fit(samples, variant));
  std::stable_sort(result.fits.begin(), result.fits.end(), [](const auto& one, const auto& other) {
    return one.errors.relative_l2 < other.errors.relative_l2;
  });
  result.verdict = verdict(result.fits);
  return result;
}

} // namespace platen::fit
