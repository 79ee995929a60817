// Law cards, and what laws say about themselves.

#include "core.hpp"

#include "core/number.hpp"
#include "dem/device_law.hpp"
#include "dem/lammps_lines.hpp"
#include "dem/law_table.hpp"
#include "dem/two_parameters.hpp"
#include "fit/initial_yield.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

namespace platen::python {
namespace {

nb::dict dict_of(const law::LawInfo& info) {
  nb::list parameters;
  for (const auto& p : info.parameters) {
    nb::dict one;
    one["key"] = p.key;
    one["meaning"] = p.meaning;
    one["range"] = law::text(p.range);
    one["required"] = std::isnan(p.fallback);
    parameters.append(one);
  }
  for (const auto& w : info.words) {
    nb::dict one;
    one["key"] = w.key;
    one["meaning"] = w.meaning;
    one["values"] = w.values;
    one["required"] = false;
    parameters.append(one);
  }
  nb::dict result;
  result["name"] = info.name;
  result["title"] = info.title;
  result["source"] = info.source;
  result["validity"] = info.validity;
  result["variants"] = law::detail::split(info.variants, '|');
  result["parameters"] = parameters;
  return result;
}

/// A hand-made card; making the law once for some radius refuses what the command would refuse.
fit::LawCard make(const std::string& name, const std::string& variant, const law::ParameterTexts& texts) {
  fit::LawCard card;
  card.law = name;
  card.variant = variant;
  card.parameters = texts;
  law::ParameterTexts radius;
  if (!texts.contains("radius_m")) radius["radius_m"] = "1e-3";
  (void)fit::make_law(card, radius);
  return card;
}

} // namespace

std::string identity(const fit::LawCard& card) {
  std::string all = card.law + " " + card.variant;
  for (const auto& [key, text] : card.parameters) {
    all += " " + key + "=";
    for (const auto& part : law::detail::split(text, ',')) {
      const auto number = core::number_from(part);
      all += (number ? core::number_text(*number) : part) + ",";
    }
  }
  return all;
}

void add_laws(nb::module_& m) {
  m.def(
      "laws",
      [] {
        nb::list list;
        for (const auto& info : law::laws()) list.append(dict_of(info));
        return list;
      },
      "What every law says about itself.");
  nb::class_<fit::LawCard>(m, "LawCard", "A law card.")
      .def_static("find", &fit::find_law_card, nb::arg("what"),
                  "A card by path or by name in the catalogue; the name of a law is an empty card of it.")
      .def_static(
          "parse",
          [](const std::string& text, const std::string& file) {
            return fit::read_law_card(core::parse_toml(text, file));
          },
          nb::arg("text"), nb::arg("file"), "A card from its text; messages call it `file`.")
      .def_static(
          "variant_of",
          [](const std::string& law, const std::string& variant) {
            auto card = fit::find_law_card(law);
            card.variant = variant;
            return card;
          },
          nb::arg("law"), nb::arg("variant"), "A card, or an empty one of a law, in another form.")
      .def_static("make", &make, nb::arg("law"), nb::arg("variant"), nb::arg("parameters"),
                  "A card from parameters as texts.")
      .def(
          "text", [](const fit::LawCard& card) { return text_of(card); }, "The card as it stands in a file.")
      .def_rw("file", &fit::LawCard::file, "Where it is from, for messages.")
      .def_prop_ro("identity", &identity,
                   "Law, variant and parameters, whatever way its numbers are written.")
      .def_ro("law", &fit::LawCard::law)
      .def_ro("variant", &fit::LawCard::variant)
      .def_prop_ro(
          "parameters", [](const fit::LawCard& card) { return card.parameters; },
          "Keys and values, as texts.")
      .def_prop_ro(
          "delta_bar",
          [](const fit::LawCard& card) -> std::optional<std::pair<double, double>> {
            if (!card.delta_bar) return {};
            return std::pair{(*card.delta_bar)[0], (*card.delta_bar)[1]};
          },
          "Smallest and largest delta/R for which it was made.")
      .def_prop_ro(
          "errors", [](const fit::LawCard& card) { return dict_of(card.errors); }, "[error]")
      .def_prop_ro(
          "provenance", [](const fit::LawCard& card) { return dict_of(card.provenance); }, "[provenance]");
  m.def(
      "engine_model",
      [](const fit::LawCard& card, double restitution, double friction) {
        auto texts = dem::engine_model(card, restitution, friction);
        return std::vector{std::move(texts.functions), std::move(texts.model), std::move(texts.use)};
      },
      nb::arg("card"), nb::arg("restitution"), nb::arg("friction"), "Texts for DEM-Engine.");
  m.def(
      "two_parameters",
      [](const fit::LawCard& card, double radius, double delta_bar) {
        const auto p = dem::two_parameters(card, radius, delta_bar);
        nb::dict hertz, springs, d;
        hertz["E_Pa"] = p.E_Pa;
        hertz["nu"] = p.nu;
        hertz["force_relative_l2"] = p.hertz_error;
        springs["k_1_N_per_m"] = p.k_1_N_per_m;
        springs["k_2_N_per_m"] = p.k_2_N_per_m;
        springs["force_relative_l2"] = p.springs_error;
        d["radius_m"] = p.radius_m;
        d["delta_bar"] = p.delta_bar;
        d["hertz"] = hertz;
        d["springs"] = springs;
        d["restitution"] = p.restitution;
        d["restitutions"] = p.restitutions;
        return d;
      },
      nb::arg("card"), nb::arg("radius"), nb::arg("delta_bar"), "The nearest laws of two numbers.");
  m.def(
      "initial_yield",
      [](const fit::LawCard& card, const law::ParameterTexts& more) {
        if (card.law != "wang")
          throw core::InvalidInput(
              fmt::format("the initial yield is told of the law wang, and this is {}", card.law));
        law::ParameterTexts texts = card.parameters;
        for (const auto& [key, text] : more) texts[key] = text;
        const auto y = fit::initial_yield(texts);
        nb::dict d;
        d["F_y_N"] = y.F_y_N;
        d["gamma_y_m"] = y.gamma_y_m;
        d["depth_over_a"] = y.depth_over_a;
        d["p0_Pa"] = y.p0_Pa;
        d["F_y_edge_N"] = y.F_y_edge_N;
        return d;
      },
      nb::arg("card"), nb::arg("more"), "Where a geomaterial starts to yield.");
  m.def(
      "law_table",
      [](const fit::LawCard& card, double radius, const std::vector<double>& overlap) {
        const law::ParameterTexts more{{"radius_m", core::number_text(radius)}};
        fit::LawCard shown = card;
        shown.parameters["radius_m"] = more.at("radius_m");
        return dem::law_table(shown, fit::make_law(card, more), overlap);
      },
      nb::arg("card"), nb::arg("radius"), nb::arg("overlap"), "A table for a DEM code.");
  m.def(
      "lammps_lines",
      [](const std::vector<fit::LawCard>& cards, const std::vector<double>& radii,
         const std::vector<double>& densities, double delta_bar) {
        std::vector<dem::ParticleType> types;
        for (std::size_t i = 0; i < cards.size(); ++i)
          types.push_back(
              {cards[i], radii.at(i), densities.at(i), std::filesystem::absolute(cards[i].file).string()});
        return dem::lammps_lines(types, delta_bar);
      },
      nb::arg("cards"), nb::arg("radius"), nb::arg("density"), nb::arg("delta_bar"),
      "Input lines for pair_style platen.");
}

} // namespace platen::python
