#include "app/large_deformation_report.hpp"

#include "core/version.hpp"
#include "platen/law/agarwal_secondary.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace platen::app {
namespace {

using Json = nlohmann::ordered_json;

std::string ratio_words(const std::vector<std::string_view>& held,
                        const std::vector<std::string_view>& on_bound, std::string_view key, double ratio) {
  if (std::ranges::count(held, key)) return "not fitted";
  return fmt::format("{:.4g}{}", ratio, std::ranges::count(on_bound, key) ? ", on its bound" : "");
}

/// Coefficients fitted and published, and how far each is from the curve.
template <class Fit, class Table> std::string comparison(const Fit& f, const Table& table) {
  std::string words = "  coefficient  fitted    published  fitted/published\n";
  for (const auto& c : table) {
    const double fitted = f.fitted.*c.member, published = f.published.*c.member;
    words += fmt::format("  {:<11}  {:<8.5g}  {:<9.5g}  {}\n", c.key, fitted, published,
                         ratio_words(f.held, f.on_bound, c.key, fitted / published));
  }
  const fit::Deviations &d = f.of_fitted, &e = f.of_published;
  if (d.points == 0)
    return words +
           fmt::format("no points from {:.4g} to {:.4g}, so law and curve are not compared\n", d.from, d.to);
  words += fmt::format("law over curve, {} points from {:.4g} to {:.4g}\n"
                       "                       fitted           published\n"
                       "                       largest  RMS     largest  RMS\n",
                       d.points, d.from, d.to);
  const auto row = [&](const char* name, const fit::RatioDeviation& one, const fit::RatioDeviation& other) {
    words += fmt::format("  {:<20} {:5.1f} %  {:4.1f} %  {:5.1f} %  {:4.1f} %\n", name, 100 * one.largest,
                         100 * one.rms, 100 * other.largest, 100 * other.rms);
  };
  row("hardness F/(pi a^2)", d.hardness, e.hardness);
  row("radius a", d.radius, e.radius);
  row("force F", d.force, e.force);
  return words;
}

template <class Fit> std::string cell_words(const Fit& f) {
  return f.loading == law::LoadingCase::simple
             ? std::string()
             : fmt::format(", cell filled at x = {:.4g}", fit::last_overlap(f.loading));
}

template <class Coefficients, class Table>
Json coefficients_json(const Coefficients& values, const Table& table) {
  Json json;
  for (const auto& c : table) json[std::string(c.key)] = values.*c.member;
  return json;
}

Json deviations_json(const fit::Deviations& d) {
  if (d.points == 0) return nullptr;
  const auto one = [](const fit::RatioDeviation& x) { return Json{{"largest", x.largest}, {"rms", x.rms}}; };
  return {{"hardness", one(d.hardness)}, {"radius", one(d.radius)}, {"force", one(d.force)}};
}

template <class Fit, class Table>
Json common_json(const char* law, const press::Curve& curve, const Fit& f, const Table& table) {
  Json held = Json::array();
  for (const auto key : f.held) held.push_back(std::string(key));
  return {
      {"platen", core::version},
      {"engine", core::engine},
      {"law", law},
      {"material", curve.material},
      {"loading", curve.experiment},
      {"fitted", coefficients_json(f.fitted, table)},
      {"published", coefficients_json(f.published, table)},
      {"not_fitted", held},
      {"fitted_range", {{"delta_bar", {f.x_from, f.x_to}}, {"points", f.points}}},
      {"compared_range", {{"delta_bar", {f.of_fitted.from, f.of_fitted.to}}, {"points", f.of_fitted.points}}},
      {"fitted_deviation", deviations_json(f.of_fitted)},
      {"published_deviation", deviations_json(f.of_published)}};
}

template <class T> Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace

std::string agarwal_words(const press::Curve& curve, const fit::AgarwalFit& f) {
  std::string words =
      fmt::format("law agarwal, loading {}, {} points from x = delta/R0 of {:.4g} to {:.4g}\n"
                  "  lambda = E/((1 - nu^2) sigma_y) = {:.5g}, zeta = B/sigma_y = {:.5g}{}\n",
                  curve.experiment, f.points, f.x_from, f.x_to, f.lambda, f.zeta, cell_words(f)) +
      comparison(f, law::agarwal_coefficients);
  if (f.Gamma)
    words += fmt::format("rho_V rho_S at x_min, Gamma (2.28): {:.4g}; published {}\n", *f.Gamma,
                         law::shahin_minimum_density_product);
  if (f.loading == law::LoadingCase::die)
    words +=
        f.side_onset
            ? fmt::format("side contacts reach that Gamma (published) at x = {:.4g}; Table 2.4 has {:.4g}\n",
                          *f.side_onset, law::secondary_onset(f.lambda))
            : fmt::format("side contacts do not reach Gamma = {} on this curve\n",
                          law::shahin_minimum_density_product);
  if (f.sides) {
    const auto published = law::side_motion(f.lambda);
    words +=
        fmt::format("sides move by gamma_s/R = {:.4g} (gamma/R)^{:.4g} (2.49), relative L2 {:.2g}; published "
                    "{:.4g} and {:.4g}\n",
                    f.sides->tau, f.sides->omega, f.sides->relative_l2, published.tau, published.omega);
  }
  return words;
}

std::string agarwal_json(const press::Curve& curve, const fit::AgarwalFit& f) {
  Json json = common_json("agarwal", curve, f, law::agarwal_coefficients);
  json["lambda"] = f.lambda;
  json["zeta"] = f.zeta;
  json["Gamma"] = or_null(f.Gamma);
  json["side_onset"] = or_null(f.side_onset);
  json["side_motion"] =
      f.sides ? Json{{"tau", f.sides->tau}, {"omega", f.sides->omega}, {"relative_L2", f.sides->relative_l2}}
              : Json(nullptr);
  return text_of(json);
}

std::string shahin_words(const press::Curve& curve, const fit::ShahinFit& f) {
  return fmt::format("law shahin, loading {}, {} points from x = delta/R0 of {:.4g} to {:.4g}\n"
                     "  1/m = {:.5g}, E/kappa = {:.5g}{}\n",
                     curve.experiment, f.points, f.x_from, f.x_to, f.inverse_m, f.E_over_kappa,
                     cell_words(f)) +
         comparison(f, law::shahin_coefficients);
}

std::string shahin_json(const press::Curve& curve, const fit::ShahinFit& f) {
  Json json = common_json("shahin", curve, f, law::shahin_coefficients);
  json["inverse_m"] = f.inverse_m;
  json["E_over_kappa"] = f.E_over_kappa;
  return text_of(json);
}

} // namespace platen::app
