#include "app/agarwal_report.hpp"

#include "core/version.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace platen::app {

std::string agarwal_words(const press::Curve& curve, const fit::AgarwalFit& f) {
  std::string words = fmt::format(
      "law agarwal, loading {}: a/R = sqrt(x) (D_1 - D_3 x + D_5 x^2), x = delta/R0, fitted to {} points "
      "from "
      "{:.4g} to {:.4g}\n"
      "  lambda = E/((1 - nu^2) sigma_y) = {:.5g}, cell filled at delta/R0 = {}\n"
      "        fitted    published  fitted/published\n",
      curve.experiment, f.points, f.delta_bar_from, f.delta_bar_to, f.lambda,
      f.loading == law::LoadingCase::simple ? "(no cell)" : fmt::format("{:.4g}", f.delta_bar_limit));
  const auto row = [&](const char* name, double fitted, double published) {
    words += fmt::format("  {}   {:<8.5g}  {:<9.5g}  {:.4g}\n", name, fitted, published, fitted / published);
  };
  row("D_1", f.fitted.D1, f.published.D1);
  row("D_3", f.fitted.D3, f.published.D3);
  row("D_5", f.fitted.D5, f.published.D5);
  words += fmt::format("  fitted radius over the curve's: RMS {:.2f} %\n", 100 * f.radius_rms);
  if (f.compared == 0)
    return words + fmt::format("  no points from {:.4g} to {:.4g}, so the published law is not compared\n",
                               f.compared_from, f.compared_to);
  words += fmt::format("published law over the curve, {} points from {:.4g} to {:.4g}\n"
                       "                       largest  RMS\n",
                       f.compared, f.compared_from, f.compared_to);
  for (const auto& [name, d] :
       {std::pair{"hardness F/(pi a^2)", f.hardness}, {"radius a", f.radius}, {"force F", f.force}})
    words += fmt::format("  {:<20} {:5.1f} %  {:4.1f} %\n", name, 100 * d.largest, 100 * d.rms);
  words += fmt::format("  with fitted D_i, a   {:5.1f} %  {:4.1f} %\n", 100 * f.fitted_radius.largest,
                       100 * f.fitted_radius.rms);
  return words + "a law card holds the published law, with these deviations as its errors\n";
}

std::string agarwal_json(const press::Curve& curve, const fit::AgarwalFit& f) {
  using Json = nlohmann::ordered_json;
  const auto radius = [](const law::RadiusPolynomial<double>& D) {
    return Json{{"D_1", D.D1}, {"D_3", D.D3}, {"D_5", D.D5}};
  };
  const auto deviation = [&](const fit::Deviation& d) {
    return f.compared ? Json{{"largest", d.largest}, {"rms", d.rms}} : Json(nullptr);
  };
  const Json json = {
      {"platen", core::version},
      {"engine", core::engine},
      {"law", "agarwal"},
      {"material", curve.material},
      {"loading", curve.experiment},
      {"lambda", f.lambda},
      {"fitted", radius(f.fitted)},
      {"published", radius(f.published)},
      {"fitted_range", {{"delta_bar", {f.delta_bar_from, f.delta_bar_to}}, {"points", f.points}}},
      {"fitted_radius_rms", f.radius_rms},
      {"compared_range", {{"delta_bar", {f.compared_from, f.compared_to}}, {"points", f.compared}}},
      {"fitted_deviation", {{"radius", deviation(f.fitted_radius)}}},
      {"published_deviation",
       {{"hardness", deviation(f.hardness)},
        {"radius", deviation(f.radius)},
        {"force", deviation(f.force)}}}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace platen::app
