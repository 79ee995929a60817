// A measured curve beside the law, and the strength that brings the law nearest to it.

#include "explorer.hpp"

#include "core/error.hpp"
#include "core/number.hpp"
#include "fit/golden.hpp"
#include "fit/samples.hpp"
#include "json.hpp"
#include "material/card.hpp"
#include "measure/stages.hpp"

#include <fmt/format.h>

#include <cmath>

namespace platen::web {
namespace {

/// With a strength, everything else as it is: ratios of strengths, E and nu. Of an elastic material E itself.
struct Strength {
  const char* key;
  double value;
};
Strength strength_of(const material::Model& model) {
  if (const auto* m = std::get_if<material::Elastic>(&model)) return {"E_Pa", m->E};
  if (const auto* m = std::get_if<material::Vmdc>(&model)) return {"sigma_y_Pa", m->sigma_y};
  if (const auto* m = std::get_if<material::DruckerPrager>(&model)) return {"sigma_c_Pa", m->sigma_c};
  return {"sigma_y_Pa", std::get<material::VonMises>(model).sigma_y};
}
material::Material with_strength(material::Material m, double value) {
  if (auto* elastic = std::get_if<material::Elastic>(&m.model)) elastic->E = value;
  else if (auto* rock = std::get_if<material::DruckerPrager>(&m.model)) rock->sigma_c = value;
  else if (auto* metal = std::get_if<material::VonMises>(&m.model)) {
    if (auto* ludwik = std::get_if<material::Ludwik>(&metal->hardening)) ludwik->K *= value / metal->sigma_y;
    metal->sigma_y = value;
  } else if (auto* granule = std::get_if<material::Vmdc>(&m.model)) {
    const double factor = value / granule->sigma_y;
    granule->sigma_y *= factor;
    granule->Gamma *= factor;
    granule->Lambda *= factor;
  }
  return m;
}

} // namespace

std::string Explorer::measured(const std::string& bytes, const std::string& name,
                               std::vector<double>& numbers) {
  const auto m = measure::read_measurement(measure::decode(bytes, name));
  if (m.specimens.empty()) throw core::InvalidInput(name + ": there is no particle in it");
  const auto& s = m.specimens.front();
  const auto stages = measure::stages_of(s);
  delta_m_.clear();
  force_N_.clear();
  for (std::size_t i = 0; i < s.force_N.size(); ++i) {
    const double delta = s.per_travel() * (s.travel_m[i] - stages.contact_travel_m);
    const double force = s.force_N[i] - stages.baseline_N;
    if (stages.broke && i >= stages.broke->row) break;
    if (stages.of_row[i] != measure::Stage::loading || !(delta > (delta_m_.empty() ? 0 : delta_m_.back())))
      continue;
    delta_m_.push_back(delta);
    force_N_.push_back(force);
  }
  if (delta_m_.size() < 8)
    throw core::InvalidInput(
        fmt::format("{}: the loading has {} points; a fit needs at least 8", name, delta_m_.size()));
  const std::size_t stride = 1 + delta_m_.size() / 400; // drawn; all of them are fitted
  for (std::size_t i = 0; i < delta_m_.size(); i += stride) {
    numbers.push_back(delta_m_[i]);
    numbers.push_back(force_N_[i]);
  }
  Json json;
  json.put("name", s.name).put("read_as", m.read_as).put("said", m.said).put("particles", m.specimens.size());
  json.put("points", delta_m_.size()).put("stages", stages.words());
  if (s.diameter_m) json.put("radius_m", s.radius_m());
  return json.text();
}

std::string Explorer::fit_strength(const law::ParameterTexts& texts, double radius_m) {
  if (delta_m_.empty()) throw core::InvalidInput("there is no measured curve to fit");
  auto own = texts;
  own.erase("radius_m");
  const auto start = material_of(own);
  const auto [key, now] = strength_of(start.model);
  const auto weights = fit::trapezoid_weights(delta_m_, 0);
  std::size_t used = 0;
  const auto squares = [&](double log_value) {
    try {
      const auto material = with_strength(start, std::exp(log_value));
      const auto card = predicted(material);
      const auto law = fit::make_law(card, {{"radius_m", core::number_text(radius_m)}, {"against", "plane"}});
      const double end = fit::validity_of(card, law).to;
      double off = 0, all = 0;
      used = 0;
      for (std::size_t i = 0; i < delta_m_.size() && delta_m_[i] <= end; ++i, ++used) {
        const double F = law::evaluate(law, {}, delta_m_[i]).force;
        off += weights[i] * (F - force_N_[i]) * (F - force_N_[i]);
        all += weights[i] * force_N_[i] * force_N_[i];
      }
      return used < 8 ? INFINITY : off / all;
    } catch (const core::InvalidInput&) { // no law of so strong or weak a material
      return static_cast<double>(INFINITY);
    }
  };
  std::vector<double> candidates;
  const double E = initial_E(start.model);
  const bool elastic = std::holds_alternative<material::Elastic>(start.model),
             rock = std::holds_alternative<material::DruckerPrager>(start.model);
  const double low = std::log(elastic ? 1e3
                              : rock  ? E / 1e4
                                      : E / 1500),
               high = std::log(elastic ? 1e13
                               : rock  ? E / 50
                                       : E / 3.2);
  for (int i = 0; i <= 24; ++i) candidates.push_back(low + (high - low) * i / 24);
  const auto best = fit::scanned_minimum(squares, candidates, 22);
  if (!std::isfinite(best.value))
    throw core::InvalidInput(
        fmt::format("no {} between {:.3g} and {:.3g} brings a law near this curve; are radius "
                    "and stiffness right?",
                    key, std::exp(low), std::exp(high)));
  (void)squares(best.at);
  Json json;
  json.put("key", key)
      .put("value", std::exp(best.at))
      .put("was", now)
      .put("relative_l2", std::sqrt(best.value));
  json.put("points", used).put("at_end", best.at - low < 1e-3 || high - best.at < 1e-3);
  return json.text();
}

} // namespace platen::web
