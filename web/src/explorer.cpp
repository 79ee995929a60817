#include "explorer.hpp"

#include "core/error.hpp"
#include "core/number.hpp"
#include "core/version.hpp"
#include "dem/lammps_lines.hpp"
#include "dem/law_table.hpp"
#include "fit/law_words.hpp"
#include "json.hpp"
#include "material/card.hpp"
#include "platen/law/edmans_sinka_appendix.hpp"
#include "surrogate/predicted_law.hpp"
#include "surrogate/said.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace platen::web {
namespace {

using surrogate::Verdict;

constexpr int points = 161, of_loop = 33, of_restitution = 61;

/// Laws of the literature that know such a material, with what it says to them.
struct Beside {
  std::string law, label;
  law::ParameterTexts texts;
};

bool knows(const law::LawInfo& info, const std::string& key) {
  return std::ranges::any_of(info.parameters, [&](const auto& p) { return p.key == key; });
}

Beside beside_of(const std::string& name, const material::Material& m) {
  auto words = fit::law_words(m);
  Beside b{name, name, {}};
  if (const auto sigma = words.find("sigma_y_Pa"); sigma != words.end()) {
    words["kappa_Pa"] = sigma->second; // laws of metals that do not harden
    words["inverse_m"] = "0";
    words["p_y_Pa"] = core::number_text(1.6 * *core::number_from(sigma->second)); // where yield begins
  }
  if (const auto* granule = std::get_if<material::Vmdc>(&m.model); granule && name == "edmans-sinka") {
    const auto a = law::edmans_sinka_appendix(granule->Gamma / granule->sigma_y,
                                              granule->E / granule->sigma_y, law::Coefficients::corrected);
    if (!a.in_range) throw core::InvalidInput("the regressions of its paper do not reach this material");
    for (const auto& [key, value] : {std::pair{"k", a.k}, {"delta_t", a.delta_t}, {"a", a.a}})
      words[key] = core::number_text(value);
    words["sigma_ref_Pa"] = core::number_text(granule->sigma_y);
  }
  const auto& info = law::find_law(name);
  for (const auto& [key, text] : words)
    if (knows(info, key)) b.texts[key] = text;
  return b;
}

bool is_rock(const material::Material& m) { return std::holds_alternative<material::DruckerPrager>(m.model); }

std::vector<std::string> laws_beside(const material::Model& model) {
  if (std::holds_alternative<material::Elastic>(model)) return {"hertz"};
  if (std::holds_alternative<material::DruckerPrager>(model)) return {"hertz", "wang"};
  if (std::holds_alternative<material::Vmdc>(model))
    return {"hertz", "edmans-sinka", "similarity", "jackson-green", "mdr", "agarwal"};
  if (const auto* metal = std::get_if<material::VonMises>(&model);
      metal && !std::holds_alternative<material::PerfectlyPlastic>(metal->hardening))
    return {"hertz", "thornton-ning", "kogut-etsion", "jackson-green", "mdr", "agarwal"};
  return {"hertz", "similarity", "thornton-ning", "kogut-etsion", "jackson-green", "mdr", "agarwal"};
}

law::ParameterTexts place(double radius_m, bool on_plane) {
  law::ParameterTexts texts{{"radius_m", core::number_text(radius_m)}};
  if (on_plane) texts["against"] = "plane";
  return texts;
}

void positive(const char* key, double value) {
  if (!(value > 0))
    throw core::InvalidInput(fmt::format("{} = {} is not > 0", key, core::number_text(value)));
}

} // namespace

material::Material material_of(const law::ParameterTexts& texts) {
  core::Table card{"material", "", 0, {{"platen", {std::int64_t{1}, 0}}}},
      parameters{"material", "parameters", 0, {}}, hardening{"material", "parameters.hardening", 0, {}};
  constexpr std::string_view hardens = "hardening.";
  for (const auto& [key, text] : texts) {
    const bool inside = key.starts_with(hardens);
    if (key == "name" || key == "model") card.entries.push_back({key, {text, 0}});
    else if (key == "hardening.kind") hardening.entries.push_back({"kind", {text, 0}});
    else if (const auto value = core::number_from(text))
      (inside ? hardening : parameters)
          .entries.push_back({inside ? key.substr(hardens.size()) : key, {*value, 0}});
    else throw core::InvalidInput(fmt::format("{} = {} is not a number", key, text));
  }
  if (!hardening.entries.empty()) parameters.entries.push_back({"hardening", {hardening, 0}});
  card.entries.push_back({"parameters", {parameters, 0}});
  return material::read_card(card).material;
}

void Explorer::load(const std::string& text) {
  if (!text.starts_with("platen-surrogate")) {
    rock_ = surrogate::read_rock(core::parse_csv(text, "grains.csv"));
    return;
  }
  surrogates_.push_back(surrogate::parse_surrogate(text, "surrogate"));
  surrogates_.back().guide.reset(); // a page presses nothing
}

int Explorer::prepare() {
  for (auto& s : surrogates_)
    for (auto& layer : s.layers)
      for (auto& process : layer.force.processes) {
        if (process.known) continue;
        remember(process, layer.inputs);
        return 1;
      }
  if (between_grains_) return 0;
  between_grains_.emplace(rock_);
  return 1;
}

const surrogate::RockInterpolation& Explorer::between_grains() {
  if (!between_grains_) between_grains_.emplace(rock_);
  return *between_grains_;
}

surrogate::Answer Explorer::ask(const material::Material& m) const {
  const auto description = surrogate::describe(m.model);
  std::optional<surrogate::Answer> best;
  for (const auto& s : surrogates_)
    if (s.model == description.model)
      if (auto better = surrogate::ask(s, description, best)) best = std::move(better);
  if (!best) throw core::InvalidInput(fmt::format("no pool has {} materials yet", description.model));
  return std::move(*best);
}

const fit::LawCard& Explorer::card() const {
  if (!card_) throw core::InvalidInput("there is no law of this material to show");
  return *card_;
}

fit::LawCard Explorer::predicted(const material::Material& m) {
  return is_rock(m) ? predict_rock(between_grains(), m, "material.toml").card
                    : surrogate::pressed_card(ask(m), m);
}

std::string Explorer::predict(const law::ParameterTexts& texts) {
  card_.reset();
  pool_.clear();
  knots_.clear();
  band_.clear();
  material_ = material_of(texts);
  Json json = is_rock(*material_) ? rock() : pressed();
  json.put("end", (*card().delta_bar)[1]).put("laws", laws_beside(material_->model));
  json.put("version", std::string(core::version));
  return json.text();
}

Json Explorer::pressed() {
  const auto answer = ask(*material_);
  const auto& s = answer.surrogate;
  const auto& p = answer.prediction;
  const auto& a = answer.assessment;
  card_ = surrogate::pressed_card(answer, *material_);
  pool_ = s.pool;
  knots_.assign(s.knots.begin(), s.knots.begin() + static_cast<std::ptrdiff_t>(a.knots));
  band_.assign(p.band.begin(), p.band.begin() + static_cast<std::ptrdiff_t>(a.knots));
  std::vector<std::string> near;
  for (const auto& one : surrogate::nearest(s, surrogate::describe(material_->model), 3))
    near.push_back(surrogate::words(s, one));
  Json json;
  json.put("verdict", std::string(name_of(a.verdict))).put("reasons", a.reasons).put("near", near);
  json.put("pool", s.pool).put("runs", s.runs.size()).put("engine", s.engine);
  return std::move(json.put("expected", p.expected[a.knots - 1]));
}

/// No band: what is known of the error is how far grains are off that are left out.
Json Explorer::rock() {
  const auto p = predict_rock(between_grains(), *material_, "material.toml");
  card_ = p.card;
  Json json;
  json.put("verdict", std::string(name_of(p.verdict))).put("reasons", p.reasons).put("near", p.near);
  json.put("pool", rock_.pool).put("runs", rock_.grains.size()).put("engine", rock_.engine);
  json.put("left_out_median", rock_.left_out.force.median).put("left_out_p95", rock_.left_out.force.p95);
  return json;
}

/// Which of these runs is nearest, and how far its force lies from that of the material: root mean square of
/// the relative difference at the knots, both as the surrogate says them.
std::string Explorer::nearest_of(const std::vector<std::string>& runs) const {
  if (!material_ || is_rock(*material_))
    throw core::InvalidInput("grains of rock were pressed at their contact alone");
  const auto s = std::ranges::find(surrogates_, pool_, &surrogate::Surrogate::pool);
  if (s == surrogates_.end()) throw core::InvalidInput("there is no law of this material");
  const auto description = surrogate::describe(material_->model);
  const auto all = surrogate::nearest(*s, description, s->runs.size());
  const auto near = std::ranges::find_if(
      all, [&](const auto& one) { return std::ranges::find(runs, s->runs[one.index]) != runs.end(); });
  if (near == all.end()) throw core::InvalidInput(fmt::format("there is no picture of pool {}", s->pool));
  const auto row = s->layers.front().inputs.row(near->index);
  const auto there = said_at(*s, {row.begin(), row.end()}).F,
             here = said_at(*s, surrogate::input_of(*s, description.coordinates)).F;
  double squares = 0;
  for (std::size_t k = 0; k < here.size(); ++k) squares += std::pow(std::exp(there[k] - here[k]) - 1, 2);
  Json json;
  json.put("run", s->runs[near->index]).put("words", surrogate::words(*s, *near));
  json.put("apart", std::sqrt(squares / static_cast<double>(here.size())));
  return json.text();
}

law::Law Explorer::law_of(double radius_m, bool on_plane) const {
  return fit::make_law(card(), place(radius_m, on_plane));
}

/// Blocks, one after the other: loading (overlap, F, a, p, stiffness), band (overlap, F low, F high), loops
/// (overlap, F, a), restitution (velocity, e), and of each law (F, 1 in its range).
std::string Explorer::curves(const Asked& asked, std::vector<double>& numbers) {
  positive("radius_m", asked.radius_m);
  positive("density", asked.density);
  law_ = law_of(asked.radius_m, asked.on_plane);
  const double per_x = 1 / law_.scale.x_per_gamma, end = (*card().delta_bar)[1] * per_x;
  const auto overlap = [&](int i) { // closer at first, where curves bend
    const double u = static_cast<double>(i) / (points - 1);
    return end * u * (0.25 + 0.75 * u);
  };
  const auto put = [&](std::initializer_list<double> row) { numbers.insert(numbers.end(), row); };
  for (int i = 0; i < points; ++i) {
    const auto r = law::evaluate(law_, {}, overlap(i));
    put({overlap(i), r.force, r.contact_radius, r.mean_pressure, r.stiffness});
  }
  for (std::size_t k = 0; k < knots_.size(); ++k) {
    const double F = law::evaluate(law_, {}, knots_[k] * per_x).force;
    put({knots_[k] * per_x, F * std::exp(-band_[k]), F * std::exp(band_[k])});
  }
  int loops = 0;
  for (const double share : {0.2, 0.4, 0.6, 0.8, 1.0}) {
    const double top = share * end;
    const double bottom = std::max(0.0, law::unloading_at(law_, top).gamma_0(top));
    if (top <= law_.gamma_elastic) continue;
    ++loops;
    for (int i = 0; i < of_loop; ++i) {
      const double u = static_cast<double>(i) / (of_loop - 1),
                   gamma = i + 1 == of_loop ? bottom : top + (bottom - top) * u * (2 - u);
      const auto r = law::evaluate(law_, {top, top}, gamma);
      if (i + 1 == of_loop && bottom > 0) put({bottom, 0, 0});
      else put({gamma, r.force, r.contact_radius});
    }
  }
  const double mass =
      asked.density * 4 / 3 * std::numbers::pi * std::pow(asked.radius_m, 3) / (asked.on_plane ? 1 : 2);
  for (int i = 0; i < of_restitution; ++i) {
    const double gamma = end * std::pow(10.0, -5.0 * (of_restitution - 1 - i) / (of_restitution - 1));
    const double work = law::loading_work(law_, gamma), lost = law::evaluate(law_, {}, gamma).dissipated_work;
    put({std::sqrt(2 * work / mass), std::sqrt(std::clamp(1 - lost / work, 0.0, 1.0))});
  }
  std::vector<Json> beside;
  for (const auto& name : asked.beside) {
    if (name.empty()) continue;
    Json json;
    json.put("law", name);
    try {
      auto b = beside_of(name, *material_);
      b.texts.merge(place(asked.radius_m, asked.on_plane));
      fit::LawCard own;
      own.law = name;
      const auto law = fit::make_law(own, b.texts);
      for (int i = 0; i < points; ++i) {
        const auto r = law::evaluate(law, {}, overlap(i));
        put({r.force, static_cast<double>(r.in_range)});
      }
      json.put("valid", law::find_law(name).validity);
    } catch (const std::exception& error) { json.put("missing", error.what()); }
    beside.push_back(std::move(json));
  }
  Json json;
  json.put("points", points).put("knots", knots_.size()).put("loops", loops).put("of_loop", of_loop);
  json.put("restitution", of_restitution).put("laws", beside).put("end_m", end);
  return json.text();
}

void Explorer::step(double overlap, std::vector<double>& numbers) {
  const auto r = law::evaluate(law_, state_, overlap);
  state_ = r.state;
  numbers = {overlap,           r.force,         r.contact_radius,
             r.mean_pressure,   r.stiffness,     static_cast<double>(r.branch),
             r.dissipated_work, state_.gamma_max};
}

std::string Explorer::file(const std::string& name, double radius_m, double density, bool on_plane) const {
  if (name == "material.toml") return material::card_text(*material_);
  auto law_card = card();
  if (name == "law.toml") return text_of(law_card);
  if (name == "law.lmp") {
    law_card.file = "law.toml";
    return dem::lammps_lines({{law_card, radius_m, density, "law.toml"}});
  }
  const auto law = law_of(radius_m, on_plane);
  for (const auto& [key, value] : place(radius_m, on_plane)) law_card.parameters[key] = value;
  std::vector<double> overlaps;
  const double end = (*card().delta_bar)[1] / law.scale.x_per_gamma;
  for (int i = 1; i <= 500; ++i) overlaps.push_back(end * i / 500);
  return dem::law_table(law_card, law, overlaps);
}

} // namespace platen::web
