#include "app/derive_local.hpp"

#include "app/press_into.hpp"
#include "app/wang_report.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/number.hpp"
#include "core/say.hpp"
#include "press/case_card.hpp"
#include "press/curve_csv.hpp"
#include "press/yield_watch.hpp"

#include <fmt/format.h>

#include <limits>

namespace platen::app {
namespace {

/// The end of loading over the overlap of first yield: WG load to 100 N, which is this for their type 1.
constexpr double omega_end = 5;

/// In digits that a person would write.
double rounded(double x) { return core::number_from(fmt::format("{:.6g}", x)).value(); }

/// From each of these shares of the way a branch unloads: a fifth would be elastic still.
std::vector<double> four_branches(double end) {
  return {rounded(0.4 * end), rounded(0.6 * end), rounded(0.8 * end), end};
}

fit::FirstYield first_yield(const material::Material& material, double radius_m) {
  const auto [phi_deg, sigma_c] = press::drucker_prager_strength(material.model);
  if (!(sigma_c > 0))
    throw core::InvalidInput(fmt::format("{}: law wang needs a material with one uniaxial strength: "
                                         "drucker-prager, mohr-coulomb, or von-mises "
                                         "without hardening",
                                         material.name));
  const fit::FirstYield yield = fit::first_yield(
      material::initial_E(material.model), material::initial_nu(material.model), phi_deg, sigma_c, radius_m);
  const double a_bar = yield.contact_radius_m / radius_m;
  if (a_bar < 2e-4 || a_bar > 0.02)
    throw core::InvalidInput(fmt::format(
        "{}: first yield comes at a contact radius of {:.2g} R; the local press resolves contacts "
        "where that is 0.0002 to 0.02 R{}",
        material.name, a_bar, a_bar > 0.02 ? "; derive edmans-sinka for softer material" : ""));
  return yield;
}

press::Case case_of(const LocalDerivation& d) {
  const fit::FirstYield yield = first_yield(d.material, d.radius_m);
  press::Local e;
  e.first_contact_bar = rounded(0.5 * yield.contact_radius_m / d.radius_m);
  const bool by_force = d.force_max_N && !d.delta_bar_max;
  if (d.force_max_N) e.force_max_N = *d.force_max_N;
  else e.force_max_N = std::numeric_limits<double>::infinity();
  if (!by_force) e.delta_bar_max = d.delta_bar_max.value_or(rounded(omega_end * yield.delta_m / d.radius_m));
  const double end = by_force ? e.force_max_N : e.delta_bar_max;
  (by_force ? e.fields_at_N : e.fields_at) = {rounded(0.2 * end), rounded(0.6 * end), end};
  if (d.unload_from.empty()) (by_force ? e.unload_from_N : e.unload_from) = four_branches(end);
  else if (d.unload_from != "none") e.unload_from = unloading_list(d.unload_from);
  const press::Case c{d.material, d.radius_m, e};
  press::validate(c);
  const double F_end = by_force ? end : 0, delta_end = by_force ? 0 : end * d.radius_m;
  if (F_end > 0 ? F_end <= yield.F_N : delta_end <= yield.delta_m)
    throw core::InvalidInput(
        fmt::format("the load ends before first yield, F_y = {:.4g} N, delta_bar = {:.4g}", yield.F_N,
                    yield.delta_m / d.radius_m));
  return c;
}

} // namespace

std::vector<double> unloading_list(const std::string& text) {
  std::vector<double> list;
  for (const auto& part : law::detail::split(text, ',')) {
    const auto number = core::number_from(part);
    if (!number)
      throw core::InvalidInput(fmt::format(
          "--unload_from {}: '{}' is not a number; write 0.1,0.3 (in units of the radius), or none", text,
          part));
    list.push_back(*number);
  }
  return list;
}

void derive_local(const LocalDerivation& d) {
  const press::Case c = case_of(d);
  const OutputFolder folder(d.folder);
  const press::Result result = press_into(c, folder, Fields::pictures).result;
  print_flags(result);
  const fit::WangFit fit = fit::fit_wang(result.curve);
  for (const auto& sentence : fit.skipped) core::say(fmt::format("note: {}\n", sentence));
  core::write_file(folder / "law.toml",
                   text_of(fit::law_card(result.curve, fit, press::curve_csv(result.curve))));
  draw_wang_fit(result.curve, fit, folder / "curve.svg");
  if (d.json) {
    fmt::print("{}", wang_json(result.curve, fit));
    return;
  }
  const auto& end = *press::loading_end(result.curve);
  fmt::print("{}: pressed to F = {:.4g} N, delta_bar = {:.4g}, contact radius {:.3g} R, in {:.1f} s\n{}",
             c.material.name, end.force_N, end.delta_bar, end.contact_radius_m / c.radius_m,
             result.statistics.total_s, wang_words(fit));
  fmt::print(
      "  law card        {0}/law.toml\n  curve           {0}/curve.csv, with the law {0}/curve.svg, with "
      "Hertz {0}/approach.svg\n  under the load  {0}/pressure.svg, {0}/zones.svg, {0}/peaks.svg\n"
      "  input, summary  {0}/case.toml, {0}/summary.json\n",
      folder.path().string());
}

} // namespace platen::app
