#include "app/fit_report.hpp"

#include "core/version.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace platen::app {
namespace {

using Json = nlohmann::ordered_json;

std::string variant_of(const FittedLaw& law) { return std::string(fit::name_of(law.loading.variant)); }

Json pressed_json(const fit::PressedFit& f) {
  const auto& m = f.material;
  return {{"law", "pressed"},
          {"knots", m.delta_bar.size()},
          {"validity", {{"delta_bar", {0.0, m.delta_bar.back()}}}},
          {"error",
           {{"relative_l2", f.errors.relative_l2},
            {"worst", f.errors.worst},
            {"radius_l2", f.errors.radius},
            {"unload_work", f.errors.unload_work},
            {"smoothed", f.residual}}},
          {"radius_measured", f.radius_measured}};
}

std::string unloading_words(const fit::UnloadingFits& unloading) {
  if (unloading.fits.empty()) return "";
  std::string words = "unloading, F = F_max ((delta - delta_0)/(delta_max - delta_0))^alpha\n"
                      "  delta_bar_max  delta_bar_0  alpha    beta     R2\n";
  for (const auto& f : unloading.fits)
    words += fmt::format("  {:<13.4g}  {:<11.4g}  {:<7.4g}  {:<7.4g}  {:.6f}\n", f.delta_bar_max,
                         f.delta_bar_0, f.alpha, f.beta, f.r_squared);
  return words;
}

Json each(const fit::UnloadingFits& unloading, double fit::UnloadingFit::*value) {
  Json list = Json::array();
  for (const auto& f : unloading.fits) list.push_back(f.*value);
  return list;
}

std::string radius_words(const fit::ContactRadius& radius) {
  if (radius.a_bar.empty()) return "  the curve has no contact radius: the law takes that of a metal\n";
  return fmt::format("  contact radius at {} overlaps: relative L2 {:.2f} %, worst row {:.2f} %\n",
                     radius.a_bar.size(), 100 * radius.relative_l2, 100 * radius.largest);
}

} // namespace

std::string fit_words(const FittedLaw& law) {
  const auto& f = law.loading;
  const auto line = [](std::string_view name, double value, const fit::Interval& interval) {
    return fmt::format("  {:<8} {:<8.4g} [{:.4g}, {:.4g}]\n", name, value, interval.low, interval.high);
  };
  return fmt::format("law edmans-sinka, {}, fitted to {} points up to delta_bar = {:.4g}\n"
                     "{}{}{}"
                     "  errors: relative L2 {:.2f} %, peak {:.2f} %, area {:.2f} %; R2 = {:.5f}\n"
                     "  in brackets: where the L2 error rises by a tenth\n"
                     "{}{}{}",
                     variant_of(law), f.points, f.delta_bar_max, line("k", f.k, f.k_interval),
                     line("delta_t", f.delta_t, f.delta_t_interval), line("a", f.a, f.a_interval),
                     100 * f.errors.relative_l2, 100 * f.errors.e_p, 100 * f.errors.e_a, f.r_squared,
                     law.verdict.empty() ? "" : fmt::format("  {}\n", law.verdict), radius_words(law.radius),
                     unloading_words(law.unloading));
}

std::string fit_words(const fit::PressedFit& f) {
  const auto& e = f.errors;
  std::string words = fmt::format("law pressed: the curve at {} knots up to delta_bar = {:.4g}\n"
                                  "  errors: relative L2 {:.2f} %, worst point {:.2f} %",
                                  f.material.delta_bar.size(), f.material.delta_bar.back(),
                                  100 * e.relative_l2, 100 * e.worst);
  if (f.radius_measured) words += fmt::format(", radius {:.2f} %", 100 * e.radius);
  if (!f.material.alpha.empty()) words += fmt::format(", work of unloading {:.2f} %", 100 * e.unload_work);
  words += "\n";
  if (!f.radius_measured) words += "  the curve has no contact radius: taken from the force\n";
  if (f.residual > 0)
    words += fmt::format("  the force falls in places: made to rise, {:.2g} % away\n", 100 * f.residual);
  return words;
}

std::string fit_json(const press::Curve& curve, const fit::PressedFit& f) {
  Json json = {{"platen", core::version}, {"engine", core::engine}, {"material", curve.material}};
  json.update(pressed_json(f));
  return json.dump(2) + "\n";
}

std::string fit_json(const press::Curve& curve, const FittedLaw& law,
                     const std::optional<fit::PressedFit>& pressed) {
  using Unloading = fit::UnloadingFit;
  const auto& f = law.loading;
  const auto interval = [](const fit::Interval& i) { return Json{i.low, i.high}; };
  Json json = {{"platen", core::version},
               {"engine", core::engine},
               {"law", "edmans-sinka"},
               {"variant", variant_of(law)},
               {"material", curve.material},
               {"parameters",
                {{"sigma_ref_Pa", curve.sigma_ref_Pa},
                 {"E_Pa", curve.E_Pa},
                 {"nu", curve.nu},
                 {"k", f.k},
                 {"delta_t", f.delta_t},
                 {"a", f.a}}},
               {"intervals",
                {{"k", interval(f.k_interval)},
                 {"delta_t", interval(f.delta_t_interval)},
                 {"a", interval(f.a_interval)}}},
               {"validity", {{"delta_bar", {0.0, f.delta_bar_max}}}},
               {"error",
                {{"relative_l2", f.errors.relative_l2},
                 {"e_p", f.errors.e_p},
                 {"e_a", f.errors.e_a},
                 {"R2", f.r_squared}}}};
  if (!law.verdict.empty()) json["verdict"] = law.verdict;
  if (pressed) json["pressed"] = pressed_json(*pressed);
  if (!law.radius.a_bar.empty()) {
    json["parameters"]["radius_delta_bar"] = law.radius.delta_bar;
    json["parameters"]["a_bar"] = law.radius.a_bar;
    json["error"]["radius_l2"] = law.radius.relative_l2;
  }
  if (!law.unloading.fits.empty()) {
    json["parameters"]["unload_delta_bar"] = each(law.unloading, &Unloading::delta_bar_max);
    json["parameters"]["alpha"] = each(law.unloading, &Unloading::alpha);
    json["parameters"]["beta"] = each(law.unloading, &Unloading::beta);
    json["error"]["unload_R2"] = each(law.unloading, &Unloading::r_squared);
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace platen::app
