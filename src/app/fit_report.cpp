#include "app/fit_report.hpp"

#include "core/fields.hpp"
#include "core/sha256.hpp"
#include "core/version.hpp"
#include "plot/curve_picture.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace platen::app {
namespace {

std::string variant_of(const fit::EdmansSinkaFit& f) { return std::string(fit::name_of(f.variant)); }

} // namespace

std::string law_card(const press::Curve& curve, const fit::EdmansSinkaFit& f, const std::string& curve_text) {
  using core::card_line;
  std::string card = card_line("platen", 1) + card_line("law", std::string("edmans-sinka")) +
                     card_line("variant", variant_of(f)) + "\n[parameters]\n";
  card += card_line("sigma_ref_Pa", curve.sigma_ref_Pa) + card_line("E_Pa", curve.E_Pa) +
          card_line("nu", curve.nu) + card_line("k", f.k) + card_line("delta_t", f.delta_t) +
          card_line("a", f.a);
  card += "\n[validity]\n" + card_line("delta_bar", std::vector{0.0, f.delta_bar_max});
  card += "\n[error]\n" + card_line("relative_l2", f.errors.relative_l2) + card_line("e_p", f.errors.e_p) +
          card_line("e_a", f.errors.e_a);
  card += "\n[provenance]\n" + card_line("material", curve.material) +
          card_line("curve_sha256", core::sha256(curve_text)) + card_line("engine", curve.engine);
  return card;
}

std::string fit_words(const fit::EdmansSinkaFit& f) {
  const auto line = [](std::string_view name, double value, const fit::Interval& interval) {
    return fmt::format("  {:<8} {:<8.4g} [{:.4g}, {:.4g}]\n", name, value, interval.low, interval.high);
  };
  return fmt::format("law edmans-sinka, {}, fitted to {} points up to delta_bar = {:.4g}\n"
                     "{}{}{}"
                     "  errors: relative L2 {:.2f} %, peak {:.2f} %, area {:.2f} %; R2 = {:.5f}\n"
                     "  in brackets: where the L2 error rises by a tenth\n",
                     fit::name_of(f.variant), f.points, f.delta_bar_max, line("k", f.k, f.k_interval),
                     line("delta_t", f.delta_t, f.delta_t_interval), line("a", f.a, f.a_interval),
                     100 * f.errors.relative_l2, 100 * f.errors.e_p, 100 * f.errors.e_a, f.r_squared);
}

std::string fit_json(const press::Curve& curve, const fit::EdmansSinkaFit& f) {
  const auto interval = [](const fit::Interval& i) { return nlohmann::ordered_json{i.low, i.high}; };
  const nlohmann::ordered_json json = {{"platen", core::version},
                                       {"engine", core::engine},
                                       {"law", "edmans-sinka"},
                                       {"variant", variant_of(f)},
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
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void draw_fit(const press::Curve& curve, const fit::EdmansSinkaFit& f, const std::filesystem::path& file) {
  constexpr int intervals = 400;
  std::vector<double> delta_bar(intervals + 1);
  for (int i = 0; i <= intervals; ++i) delta_bar[i] = f.delta_bar_max * i / intervals;
  plot::curve_with_law(curve, delta_bar, f.F_bar(delta_bar),
                       fmt::format("edmans-sinka, {}", fit::name_of(f.variant)), file);
}

} // namespace platen::app
