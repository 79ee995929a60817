#include "app/wang_report.hpp"

#include "core/version.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace platen::app {
namespace {

using Json = nlohmann::ordered_json;

} // namespace

std::string wang_words(const fit::WangFit& f) {
  std::string words = fmt::format(
      "law wang, F/F_y = a (delta/delta_y)^b, fitted to {} points with delta/delta_y from 1 to {:.4g}\n"
      "  F_y = {:.5g} N, delta_y = {:.5g} m of one sphere; delta is Hertz-consistent, the far field of the "
      "sphere taken out\n"
      "  a        {:.5g}\n  b        {:.5g}\n  R2 = {:.7f}, RMSE = {:.3g} F_y; other forms:\n",
      f.points, f.omega_max, f.F_y_N, f.delta_y_m, f.a, f.b, f.r_squared, f.rmse);
  for (const auto& form : f.others)
    words += fmt::format("    {:<12} {} parameters  R2 = {:.7f}, RMSE = {:.3g} F_y\n", form.name,
                         form.parameters, form.r_squared, form.rmse);
  if (f.unloading.empty()) return words;
  words += "unloading, F/F_y = m ((delta - delta_res)/delta_y)^n\n"
           "  delta_max/delta_y  m        n        delta_res_m  R2\n";
  for (const auto& u : f.unloading)
    words += fmt::format("  {:<17.4g}  {:<7.4g}  {:<7.4g}  {:<11.4g}  {:.6f}\n", u.omega_max, u.m, u.n,
                         u.delta_res_m, u.r_squared);
  if (f.unloading.size() > 1)
    words += fmt::format("  {:<17}  {:<7.4g}  {:<7.4g}  {:<11}  {:.6f}\n", "together", f.m, f.n, "",
                         f.unloading_r_squared);
  return words;
}

std::string wang_json(const press::Curve& curve, const fit::WangFit& f) {
  Json json = {{"platen", core::version},
               {"engine", core::engine},
               {"law", "wang"},
               {"material", curve.material},
               {"parameters",
                {{"E_Pa", curve.E_Pa},
                 {"nu", curve.nu},
                 {"phi_deg", curve.phi_deg},
                 {"sigma_c_Pa", curve.sigma_c_Pa},
                 {"a", f.a},
                 {"b", f.b}}},
               {"F_y_N", f.F_y_N},
               {"delta_y_m", f.delta_y_m},
               {"approach", "hertz-consistent"},
               {"validity", {{"delta_over_delta_y", {1.0, f.omega_max}}}},
               {"error", {{"R2", f.r_squared}, {"rmse_over_F_y", f.rmse}}}};
  for (const auto& form : f.others)
    json["other_forms"][form.name] = {
        {"parameters", form.parameters}, {"R2", form.r_squared}, {"rmse_over_F_y", form.rmse}};
  json["unloading"] = Json::array();
  for (const auto& u : f.unloading)
    json["unloading"].push_back({{"delta_max_over_delta_y", u.omega_max},
                                 {"m", u.m},
                                 {"n", u.n},
                                 {"delta_res_m", u.delta_res_m},
                                 {"R2", u.r_squared}});
  if (!f.unloading.empty()) {
    json["parameters"]["m"] = f.m;
    json["parameters"]["n"] = f.n;
    json["error"]["unload_R2"] = f.unloading_r_squared;
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace platen::app
