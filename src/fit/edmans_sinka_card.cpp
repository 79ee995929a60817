#include "fit/edmans_sinka_card.hpp"

#include "core/error.hpp"
#include "core/number.hpp"
#include "core/sha256.hpp"
#include "platen/law/edmans_sinka.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>

namespace platen::fit {
namespace {

void check_branches(const UnloadingFits& unloading) {
  constexpr std::size_t most = law::EdmansSinkaMaterial::most_unloadings;
  const auto& fits = unloading.fits;
  if (fits.size() > most)
    throw core::InvalidInput(
        fmt::format("a law card holds {} unloading branches, and the curve has {}; leave some of them out",
                    most, fits.size()));
  for (std::size_t i = 1; i < fits.size(); ++i)
    if (!(fits[i - 1].delta_bar_max < fits[i].delta_bar_max))
      throw core::InvalidInput(fmt::format("two unloading branches, {} and {}, leave the curve at delta_bar "
                                           "= {}; a law card wants one of them",
                                           fits[i - 1].branch_id, fits[i].branch_id,
                                           core::number_text(fits[i].delta_bar_max)));
}

std::string list_of(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : ",") + core::number_text(number);
  return text;
}

std::vector<double> each(const UnloadingFits& unloading, double UnloadingFit::*value) {
  std::vector<double> values;
  for (const auto& fit : unloading.fits) values.push_back(fit.*value);
  return values;
}

} // namespace

LawCard law_card(const press::Curve& curve, const FittedLaw& fitted, std::string_view curve_text) {
  const auto& [loading, radius, unloading, verdict] = fitted;
  check_branches(unloading);
  LawCard card;
  card.law = "edmans-sinka";
  card.variant = name_of(loading.variant);
  for (const auto& [key, value] :
       {std::pair{"sigma_ref_Pa", curve.sigma_ref_Pa}, std::pair{"E_Pa", curve.E_Pa},
        std::pair{"nu", curve.nu}, std::pair{"k", loading.k}, std::pair{"delta_t", loading.delta_t},
        std::pair{"a", loading.a}})
    card.parameters[key] = core::number_text(value);
  card.delta_bar = {0, loading.delta_bar_max};
  card.errors = {
      {"relative_l2", loading.errors.relative_l2}, {"e_p", loading.errors.e_p}, {"e_a", loading.errors.e_a}};
  if (!radius.a_bar.empty()) {
    card.parameters["radius_delta_bar"] = fmt::format("{:.6g}", fmt::join(radius.delta_bar, ","));
    card.parameters["a_bar"] = fmt::format("{:.6g}", fmt::join(radius.a_bar, ","));
    card.errors.emplace_back("radius_l2", radius.relative_l2);
  }
  if (!unloading.fits.empty()) {
    card.parameters["unload_delta_bar"] = list_of(each(unloading, &UnloadingFit::delta_bar_max));
    card.parameters["alpha"] = list_of(each(unloading, &UnloadingFit::alpha));
    card.parameters["beta"] = list_of(each(unloading, &UnloadingFit::beta));
    card.errors.emplace_back("unload_R2", each(unloading, &UnloadingFit::r_squared));
  }
  card.provenance = {
      {"material", curve.material}, {"curve_sha256", core::sha256(curve_text)}, {"engine", curve.engine}};
  return card;
}

} // namespace platen::fit
