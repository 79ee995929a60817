#include "fit/derivation.hpp"

#include "core/error.hpp"
#include "core/number.hpp"
#include "fit/edmans_sinka_card.hpp"
#include "fit/wang.hpp"
#include "platen/law/edmans_sinka.hpp"
#include "press/case_card.hpp"
#include "press/curve_csv.hpp"
#include "press/strength.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>

namespace platen::fit {
namespace {

/// In digits that a person would write.
double rounded(double x) { return core::number_from(fmt::format("{:.6g}", x)).value(); }

/// Where the zone map looks: early, in the middle, at the end.
std::vector<double> moments(double end) { return {0.2 * end, 0.6 * end, end}; }

/// Five branches show how alpha and beta change with the overlap (ES Fig. 15).
std::vector<double> fifths(double end) {
  std::vector<double> list;
  for (int i = 1; i < 5; ++i) list.push_back(rounded(end * i / 5));
  list.push_back(end);
  return list;
}

/// From each of these shares of the way a branch unloads: a fifth would be elastic still.
std::vector<double> four_branches(double end) {
  return {rounded(0.4 * end), rounded(0.6 * end), rounded(0.8 * end), end};
}

/// The end of local loading over the overlap of first yield: WG load to 100 N, which is this for their
/// type 1.
constexpr double omega_end = 5;

FirstYield first_yield_of(const material::Material& material, double radius_m) {
  const auto [phi_deg, sigma_c] = press::drucker_prager_strength(material.model);
  if (!(sigma_c > 0))
    throw core::InvalidInput(fmt::format("{}: law wang needs a material with one uniaxial strength: "
                                         "drucker-prager, mohr-coulomb, or von-mises "
                                         "without hardening",
                                         material.name));
  const FirstYield yield = first_yield(material::initial_E(material.model),
                                       material::initial_nu(material.model), phi_deg, sigma_c, radius_m);
  const double a_bar = yield.contact_radius_m / radius_m;
  if (a_bar < 2e-4 || a_bar > 0.02)
    throw core::InvalidInput(fmt::format(
        "{}: first yield comes at a contact radius of {:.2g} R; the local press resolves contacts "
        "where that is 0.0002 to 0.02 R{}",
        material.name, a_bar, a_bar > 0.02 ? "; derive edmans-sinka for softer material" : ""));
  return yield;
}

} // namespace

press::Case simple_derivation(const material::Material& material, double radius_m, press::Simple e,
                              const std::optional<std::vector<double>>& unload_from) {
  constexpr std::size_t most = law::EdmansSinkaMaterial::most_unloadings;
  e.unload_from = unload_from.value_or(fifths(e.delta_bar_max));
  if (e.unload_from.size() > most)
    throw core::InvalidInput(
        fmt::format("--unload_from {}: a law card holds {} branches at most, these are {}",
                    fmt::join(e.unload_from, ","), most, e.unload_from.size()));
  e.fields_at = moments(e.delta_bar_max);
  const press::Case c{material, radius_m, e};
  press::validate(c);
  return c;
}

DerivedLaws derive_laws(const press::Result& result, const std::string& variant, const Say& say) {
  FittedLaw fitted = fit_law(result.curve, variant, say);
  PressedFit pressed = fit_pressed(result.curve, fitted.unloading);
  const std::string text = press::curve_csv(result.curve);
  LawCard fitted_card = law_card(result.curve, fitted, text);
  LawCard pressed_card = law_card(result.curve, pressed, text);
  if (!fitted.loading.on_bound().empty()) {
    const std::string doubt = "a ended on its bound: the form of edmans-sinka does not follow this curve";
    say("note: " + doubt);
    fitted_card.provenance.emplace_back("doubts", doubt);
  }
  if (result.error)
    for (LawCard* card : {&fitted_card, &pressed_card}) {
      card->errors.emplace_back("press_force", result.error->force);
      card->errors.emplace_back("press_radius", result.error->radius);
    }
  return {std::move(fitted), std::move(pressed), std::move(fitted_card), std::move(pressed_card)};
}

press::Case local_derivation(const material::Material& material, double radius_m, const LocalReach& reach) {
  const FirstYield yield = first_yield_of(material, radius_m);
  press::Local e;
  e.first_contact_bar = rounded(0.5 * yield.contact_radius_m / radius_m);
  const bool by_force = reach.force_max_N && !reach.delta_bar_max;
  e.force_max_N = reach.force_max_N.value_or(std::numeric_limits<double>::infinity());
  if (!by_force)
    e.delta_bar_max = reach.delta_bar_max.value_or(rounded(omega_end * yield.delta_m / radius_m));
  const double end = by_force ? e.force_max_N : e.delta_bar_max;
  (by_force ? e.fields_at_N : e.fields_at) = {rounded(0.2 * end), rounded(0.6 * end), end};
  if (reach.unload_from) e.unload_from = *reach.unload_from;
  else (by_force ? e.unload_from_N : e.unload_from) = four_branches(end);
  const press::Case c{material, radius_m, e};
  press::validate(c);
  const double F_end = by_force ? end : 0, delta_end = by_force ? 0 : end * radius_m;
  if (F_end > 0 ? F_end <= yield.F_N : delta_end <= yield.delta_m)
    throw core::InvalidInput(
        fmt::format("the load ends before first yield, F_y = {:.4g} N, delta_bar = {:.4g}", yield.F_N,
                    yield.delta_m / radius_m));
  return c;
}

} // namespace platen::fit
