#include "calibrate/free_parameters.hpp"

#include "core/error.hpp"
#include "core/nearest.hpp"

#include <fmt/format.h>

namespace platen::calibrate {
namespace {

const std::vector<FreeLaw>& all() {
  static const std::vector<FreeLaw> laws = [] {
    const FreeParameter E{"E_Pa", true, true, 0.5, 1e6, {3, 12, 50, 200, 800, 3200}, false};
    FreeParameter E_unloading = E;
    E_unloading.of_unloading = true;
    const FreeParameter sigma_y{"sigma_y_Pa", true, true, 1e-4, 10, {0.03, 0.06, 0.12, 0.2, 0.4, 0.8}, false};
    const FreeParameter kappa{"kappa_Pa", true, true, 1e-3, 100, {0.06, 0.12, 0.25, 0.5, 1, 2}, false};
    const FreeParameter inverse_m{"inverse_m", false, false, 0, 1, {0.05, 0.2, 0.4, 0.6, 0.8, 0.95}, false};
    FreeParameter p_y = sigma_y;
    p_y.key = "p_y_Pa";
    p_y.high = 30;
    std::vector<FreeLaw> list = {
        {"hertz", {{"E_Pa", true, true, 1e-3, 1e6, {0.5, 2, 8, 32, 128}, false}}, "", true},
        {"shahin", {kappa, inverse_m, E_unloading}, "kappa_Pa", true},
        {"similarity", {kappa, inverse_m, E_unloading}, "kappa_Pa", true},
        {"agarwal", {sigma_y, E}, "sigma_y_Pa", true},
        {"thornton-ning", {p_y, E}, "p_y_Pa", true},
        {"wang",
         {{"sigma_c_Pa", true, true, 1e-3, 100, {0.03, 0.1, 0.3, 1}, false},
          {"phi_deg", false, false, 1, 59, {20, 30, 40}, false}},
         "sigma_c_Pa",
         true},
        {"edmans-sinka",
         {{"k", true, false, 1e-2, 1e3, {0.5, 1, 2, 4}, false},
          {"delta_t", false, false, 1e-3, 0.5, {0.02, 0.08, 0.2}, false},
          {"a", false, false, 1e-3, 50, {1, 3, 8}, false}},
         "sigma_ref_Pa",
         false},
        {"eepa",
         {{"E_Pa", true, true, 1e-4, 1e4, {0.1, 1, 10, 100}, false},
          {"n", false, false, 1, 2, {1.1, 1.5, 1.9}, false},
          {"lambda_p", false, false, 1e-3, 0.999, {0.3, 0.9}, true}},
         "",
         true,
         1e6,
         false}, // unless n is 3/2
    };
    for (const std::string_view name : {"kogut-etsion", "etsion-unloading", "jackson-green", "mdr"})
      list.push_back({name, {sigma_y, E}, "sigma_y_Pa", true, name == "jackson-green" ? 2e4 : 1e6});
    return list;
  }();
  return laws;
}

} // namespace

const FreeLaw& free_law(const std::string& name) {
  for (const auto& law : all())
    if (law.law == name) return law;
  const auto known = calibrated_laws();
  throw core::InvalidInput(
      fmt::format("--law {}: there is no such law to calibrate{}", name, core::suggestion(name, known)));
}

std::vector<std::string> calibrated_laws() {
  std::vector<std::string> names;
  for (const auto& law : all()) names.emplace_back(law.law);
  return names;
}

} // namespace platen::calibrate
