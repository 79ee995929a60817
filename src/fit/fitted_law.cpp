#include "fit/fitted_law.hpp"

#include "core/error.hpp"
#include "core/nearest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace platen::fit {

void check_variant(const std::string& variant) {
  std::vector<std::string> known = {"best"};
  for (const auto name : edmans_sinka_variants()) known.emplace_back(name);
  if (std::ranges::find(known, variant) == known.end())
    throw core::InvalidInput(fmt::format("--variant {}: there is no such form to fit; there are {}{}",
                                         variant, fmt::join(known, ", "), core::suggestion(variant, known)));
}

UnloadingFits unloading_of(const press::Curve& curve, const Say& say) {
  const bool unloads = std::ranges::any_of(
      curve.points, [](const auto& point) { return point.branch == press::Branch::unloading; });
  UnloadingFits fits;
  if (unloads && !(curve.E_Pa > 0))
    fits.skipped = {
        "the unloading branches are not fitted: the curve says no elasticity; give --E_Pa and --nu"};
  else fits = fit_unloading(curve);
  for (const auto& sentence : fits.skipped) say(fmt::format("note: {}", sentence));
  return fits;
}

FittedLaw fit_law(const press::Curve& curve, const std::string& variant, const Say& say) {
  check_variant(variant);
  FittedLaw law;
  if (variant == "best") {
    auto comparison = fit_best(curve);
    law.loading = comparison.fits.front();
    law.verdict = comparison.verdict;
  } else law.loading = fit_edmans_sinka(curve, variant);
  law.radius = fit_contact_radius(curve);
  law.unloading = unloading_of(curve, say);
  return law;
}

} // namespace platen::fit
