#include "surrogate/predicted_law.hpp"

#include "core/error.hpp"
#include "core/number.hpp"
#include "fit/edmans_sinka_card.hpp"
#include "press/case.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace platen::surrogate {
namespace {

/// Six digits, as in the pool.
std::string list_of(const std::vector<double>& values) {
  std::string text;
  for (const double value : values)
    text += (text.empty() ? "" : ",") + core::number_text(*core::number_from(fmt::format("{:.6g}", value)));
  return text;
}

std::vector<double> rounded(const std::vector<double>& values) {
  std::vector<double> result;
  for (const double value : values) result.push_back(*core::number_from(fmt::format("{:.3g}", value)));
  return result;
}

/// A law wants an exponent of 1 at least; fitted ones are held there as well.
std::vector<double> exponents(const Prediction& p) {
  auto alpha = p.alpha;
  for (double& one : alpha) one = std::clamp(one, 1.0, 10.0);
  return alpha;
}

void say_where_from(fit::LawCard& card, const Answer& answer, const material::Material& material) {
  const Surrogate& s = answer.surrogate;
  card.errors.emplace_back("band_90", rounded(answer.prediction.band));
  card.provenance = {{"material", material.name},
                     {"pool", s.pool},
                     {"runs", static_cast<int>(s.runs.size())},
                     {"verdict", std::string(name_of(answer.assessment.verdict))},
                     {"engine", s.engine}};
}

} // namespace

fit::LawCard pressed_card(const Answer& answer, const material::Material& material) {
  const Prediction& p = answer.prediction;
  const auto& knots = answer.surrogate.knots;
  for (const auto* list : {&p.F_bar, &p.a_bar})
    for (std::size_t i = 1; i < list->size(); ++i)
      if (!((*list)[i] > (*list)[i - 1]))
        throw core::InvalidInput(fmt::format("{}: the predicted {} does not grow at delta/R0 = {:.4g}, which the law "
                                             "pressed cannot hold; `platen derive` presses the material",
                                             material.name, list == &p.F_bar ? "force" : "contact radius", knots[i]));
  fit::LawCard card;
  card.law = "pressed";
  card.parameters = {{"E_Pa", core::number_text(material::initial_E(material.model))},
                     {"nu", core::number_text(material::initial_nu(material.model))},
                     {"sigma_ref_Pa", core::number_text(material::reference_stress(material.model))},
                     {"delta_bar", list_of(knots)},
                     {"F_bar", list_of(p.F_bar)},
                     {"a_bar", list_of(p.a_bar)},
                     {"unload_delta_bar", list_of(answer.surrogate.unload_delta_bar)},
                     {"alpha", list_of(exponents(p))},
                     {"beta", list_of(p.beta)}};
  card.delta_bar = {0, knots.back()};
  card.errors = {{"relative_l2", rounded({p.expected})[0]}};
  say_where_from(card, answer, material);
  return card;
}

fit::LawCard edmans_sinka_card(const Answer& answer, const material::Material& material, const std::string& variant) {
  const Prediction& p = answer.prediction;
  const Surrogate& s = answer.surrogate;
  press::Curve curve;
  curve.radius_m = 1;
  curve.sigma_ref_Pa = material::reference_stress(material.model);
  curve.E_Pa = material::initial_E(material.model);
  curve.nu = material::initial_nu(material.model);
  curve.experiment = press::Simple::name;
  curve.material = material.name;
  curve.engine = s.engine;
  for (std::size_t i = 0; i < s.knots.size(); ++i) {
    press::CurvePoint point;
    point.delta_bar = point.delta_m = s.knots[i];
    point.F_bar = p.F_bar[i];
    curve.points.push_back(point);
  }
  fit::UnloadingFits unloading;
  const auto alpha = exponents(p);
  for (std::size_t b = 0; b < alpha.size(); ++b) {
    fit::UnloadingFit fit;
    fit.branch_id = static_cast<int>(b) + 1;
    fit.delta_bar_max = s.unload_delta_bar[b];
    fit.alpha = alpha[b];
    fit.beta = p.beta[b];
    unloading.fits.push_back(fit);
  }
  auto card = fit::law_card(curve, fit::fit_edmans_sinka(curve, variant), unloading, "");
  std::erase_if(card.errors, [](const auto& error) { return error.first == "unload_R2"; });
  card.errors.emplace_back("predicted_curve", rounded({p.expected})[0]);
  say_where_from(card, answer, material);
  return card;
}

} // namespace platen::surrogate
