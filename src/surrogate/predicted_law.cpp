#include "surrogate/predicted_law.hpp"

#include "core/error.hpp"
#include "core/number.hpp"
#include "fit/edmans_sinka_card.hpp"
#include "fit/refine_unloading.hpp"
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

/// What of the prediction the law holds: up to the last knot that may be used.
struct Held {
  std::vector<double> knots, F_bar, a_bar, band, unload_delta_bar, alpha, beta;
  double expected;
};

Held held(const Answer& answer) {
  const auto& s = answer.surrogate;
  const auto& p = answer.prediction;
  const auto& a = answer.assessment;
  const auto first = [&](const std::vector<double>& values, std::size_t count) {
    return std::vector<double>(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count));
  };
  const double end = s.knots[a.knots - 1];
  const auto branches = static_cast<std::size_t>(std::count_if(
      s.unload_delta_bar.begin(), s.unload_delta_bar.end(), [&](double x) { return x <= end; }));
  Held h{first(s.knots, a.knots),
         first(p.F_bar, a.knots),
         first(p.a_bar, a.knots),
         first(p.band, a.knots),
         first(s.unload_delta_bar, branches),
         first(p.alpha, branches),
         first(p.beta, branches),
         p.expected[a.knots - 1]};
  for (double& alpha : h.alpha)
    alpha = std::clamp(alpha, 1.0, 10.0); // what laws take; fits are held there as well
  return h;
}

void say_where_from(fit::LawCard& card, const Answer& answer, const Held& h,
                    const material::Material& material) {
  const Surrogate& s = answer.surrogate;
  card.errors.emplace_back("band_90", rounded(h.band));
  card.provenance = {{"material", material.name},
                     {"pool", s.pool},
                     {"runs", static_cast<int>(s.runs.size())},
                     {"verdict", std::string(name_of(answer.assessment.verdict))},
                     {"engine", s.engine}};
  if (answer.guided) card.provenance.emplace_back("guide_elements", s.guide->elements);
}

/// The law pressed wants curves that grow: held level where they fall, by less than is known of them anyway.
/// `most`: the largest share by which a value was raised.
std::vector<double> growing(const std::vector<double>& values, double least, double& most) {
  std::vector<double> result;
  for (const double value : values) {
    result.push_back(result.empty() ? value : std::max(value, result.back() * (1 + least)));
    most = std::max(most, result.back() / value - 1);
  }
  return result;
}

} // namespace

fit::LawCard pressed_card(const Answer& answer, const material::Material& material) {
  const Held h = held(answer);
  double raised = 0, raised_a = 0;
  const auto F_bar = growing(h.F_bar, 2e-5, raised), a_bar = growing(h.a_bar, 0, raised_a);
  if (raised > std::max(0.02, *std::max_element(h.band.begin(), h.band.end())))
    throw core::InvalidInput(fmt::format("{}: the predicted force falls by {:.2g} % while the overlap grows, "
                                         "which the law pressed cannot hold; --law "
                                         "edmans-sinka, or `platen press`, can",
                                         material.name, 100 * raised));
  fit::LawCard card;
  card.law = "pressed";
  law::PressedMaterial unloading;
  unloading.unload_delta_bar = h.unload_delta_bar, unloading.alpha = h.alpha, unloading.beta = h.beta;
  fit::refine_unloading(unloading);
  card.parameters = {{"E_Pa", core::number_text(material::initial_E(material.model))},
                     {"nu", core::number_text(material::initial_nu(material.model))},
                     {"sigma_ref_Pa", core::number_text(answer.sigma_ref)},
                     {"delta_bar", list_of(h.knots)},
                     {"F_bar", list_of(F_bar)},
                     {"a_bar", list_of(a_bar)},
                     {"unload_delta_bar", list_of(unloading.unload_delta_bar)},
                     {"alpha", list_of(unloading.alpha)},
                     {"beta", list_of(unloading.beta)}};
  card.delta_bar = {0, h.knots.back()};
  card.errors = {{"relative_l2", rounded({h.expected})[0]}};
  if (std::max(raised, raised_a) > 1e-4)
    card.errors.emplace_back("held_level", rounded({std::max(raised, raised_a)})[0]);
  say_where_from(card, answer, h, material);
  return card;
}

fit::LawCard edmans_sinka_card(const Answer& answer, const material::Material& material,
                               const std::string& variant) {
  const Held h = held(answer);
  press::Curve curve;
  curve.radius_m = 1;
  curve.sigma_ref_Pa = answer.sigma_ref;
  curve.E_Pa = material::initial_E(material.model);
  curve.nu = material::initial_nu(material.model);
  curve.experiment = press::Simple::name;
  curve.material = material.name;
  curve.engine = answer.surrogate.engine;
  for (std::size_t i = 0; i < h.knots.size(); ++i) {
    press::CurvePoint point;
    point.delta_bar = point.delta_m = h.knots[i];
    point.F_bar = h.F_bar[i];
    point.contact_radius_m = h.a_bar[i];
    curve.points.push_back(point);
  }
  fit::UnloadingFits unloading;
  for (std::size_t b = 0; b < h.alpha.size(); ++b) {
    fit::UnloadingFit fit;
    fit.branch_id = static_cast<int>(b) + 1;
    fit.delta_bar_max = h.unload_delta_bar[b];
    fit.alpha = h.alpha[b];
    fit.beta = h.beta[b];
    unloading.fits.push_back(fit);
  }
  auto card = fit::law_card(
      curve, {fit::fit_edmans_sinka(curve, variant), fit::fit_contact_radius(curve), unloading, ""}, "");
  std::erase_if(card.errors, [](const auto& error) { return error.first == "unload_R2"; });
  card.errors.emplace_back("predicted_curve", rounded({h.expected})[0]);
  say_where_from(card, answer, h, material);
  return card;
}

} // namespace platen::surrogate
