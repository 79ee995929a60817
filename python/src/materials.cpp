// Material cards, and laws predicted from them.

#include "core.hpp"

#include "calibrate/compaction_files.hpp"
#include "core/file.hpp"
#include "fit/convert_deck.hpp"
#include "material/card.hpp"
#include "material/walk.hpp"
#include "plot/gnuplot.hpp"
#include "plot/walk_picture.hpp"
#include "study/card.hpp"
#include "surrogate/predict_law.hpp"
#include "surrogate/rock.hpp"
#include "surrogate/yield_from.hpp"

namespace platen::python {
namespace {

using material::Card;

Card as_model(const Card& card, const std::string& name) {
  Card other = card;
  other.material.model = material::run_as(card.material.model, name);
  return other;
}

nb::dict dict_of(const surrogate::PredictedRock& p) {
  nb::dict d;
  d["pool"] = p.rock.pool;
  d["engine"] = p.rock.engine;
  d["verdict"] = std::string(name_of(p.verdict));
  d["reasons"] = p.reasons;
  d["F_y_over_F"] = p.yield;
  for (std::size_t k = 0; k < p.of.size(); ++k) d[surrogate::coefficient_names[k]] = p.of[k];
  return d;
}

nb::dict dict_of(const surrogate::Answer& answer) {
  const auto& s = answer.surrogate;
  const auto& p = answer.prediction;
  const auto& a = answer.assessment;
  nb::dict d;
  d["pool"] = s.pool;
  d["engine"] = s.engine;
  d["guided"] = answer.guided;
  d["verdict"] = std::string(name_of(a.verdict));
  d["reasons"] = a.reasons;
  d["expected_error"] = p.expected[a.knots - 1];
  d["delta_bar_end"] = s.knots[a.knots - 1];
  d["delta_bar"] = array_of(s.knots);
  d["F_bar"] = array_of(p.F_bar);
  d["band_90"] = array_of(p.band);
  d["a_bar"] = array_of(p.a_bar);
  d["unload_delta_bar"] = array_of(s.unload_delta_bar);
  d["alpha"] = array_of(p.alpha);
  d["beta"] = array_of(p.beta);
  return d;
}

nb::tuple predict(const Card& card, const std::string& asked, const std::string& variant, bool quick,
                  bool extrapolate) {
  std::vector<std::string> said;
  const auto law = surrogate::law_to_predict(card.material, asked);
  if (law == "wang") {
    auto rock = surrogate::predict_rock(card.material, card.file);
    const auto about = dict_of(rock);
    return nb::make_tuple(std::move(rock.card), said, rock.near, about);
  }
  auto predicted = long_work([&] {
    return surrogate::predict_law(card.material, {law, variant, quick, extrapolate, card.file},
                                  [&](const std::string& sentence) { said.push_back(sentence); });
  });
  std::vector<std::string> near;
  for (const auto& one : predicted.near) near.push_back(words(predicted.answer.surrogate, one));
  return nb::make_tuple(std::move(predicted.card), said, near, dict_of(predicted.answer));
}

/// Rows of a way, and why it ends early.
nb::tuple walk(const Card& card, const std::string& name, const std::vector<std::array<double, 3>>& rows,
               double strain, double lateral, double compaction, int steps, const std::string& moduli,
               const std::string& picture) {
  if (!picture.empty()) (void)plot::format_of(picture); // before any work
  const material::Way way{name, strain, lateral, compaction, steps, moduli, rows};
  const auto& model = card.material.model;
  const auto w = long_work([&] {
    auto walked = material::walk(model, way);
    if (!picture.empty()) plot::walk_picture(card.material, way, walked, picture);
    return walked;
  });
  std::vector<double> rows_out;
  std::vector<int> zones;
  for (const auto& [total, elastic, phi, last] : w.points) {
    for (const double number : {total[0], total[1], total[2], last.sigma[0], last.sigma[1], last.sigma[2],
                                last.p, last.q, phi, material::relative_density(model, phi)})
      rows_out.push_back(number);
    zones.push_back(static_cast<int>(last.zone));
  }
  return nb::make_tuple(array_of(rows_out), zones, w.refusal);
}

nb::tuple from_deck(const std::string& file, const std::string& units, const std::string& name,
                    std::optional<double> rho_r0, bool despite_doubts) {
  if (!core::is_there(file)) throw core::InvalidInput(file + ": there is no such file");
  const auto decks = material::read_deck(core::read_file(file), file);
  const auto& deck = material::choose(decks, name);
  if (units.empty()) throw core::InvalidInput(material::which_units(deck));
  const auto c = fit::convert_deck(deck, material::deck_units(units), rho_r0, despite_doubts);
  return nb::make_tuple(material::read_card(core::parse_toml(c.card, file)), c.said, c.left_over, c.doubts);
}

nb::tuple from_compaction(const std::string& test, const std::string& strengths, double rho_r0,
                          const std::string& model, const std::string& name) {
  const calibrate::CompactionFiles files{test, strengths, rho_r0, model, name};
  const auto c = long_work([&] { return calibrate::compaction(files); });
  nb::list trends;
  for (const auto& t : c.trends) {
    nb::dict one;
    one["key"] = t.key;
    one["value"] = t.value;
    one["growth_key"] = t.growth_key;
    one["growth"] = t.growth;
    one["R2"] = t.R2;
    one["points"] = t.points;
    one["rho_r"] = nb::make_tuple(t.low, t.high);
    trends.append(one);
  }
  nb::dict d;
  d["trends"] = trends;
  d["axial_relative_l2"] = c.axial_l2;
  d["radial_relative_l2"] = c.radial_l2;
  d["remarks"] = c.said;
  d["words"] = words_of(c, files);
  return nb::make_tuple(material::read_card(core::parse_toml(card_of(c, files), test)), d);
}

std::pair<std::string, std::vector<std::string>> to_deck(const Card& card, const std::string& units) {
  auto deck = material::deck_of(card.material, material::deck_units(units));
  return {std::move(deck.text), std::move(deck.left_over)};
}

} // namespace

void add_materials(nb::module_& m) {
  nb::class_<Card>(m, "MaterialCard", "A material card.")
      .def_static(
          "find", [](const std::string& what) { return material::read_card(what); }, nb::arg("what"),
          "A card by path or by name in the catalogue.")
      .def_static(
          "parse",
          [](const std::string& text, const std::string& file) {
            return material::read_card(core::parse_toml(text, file));
          },
          nb::arg("text"), nb::arg("file"), "A card from its text; messages call it `file`.")
      .def(
          "text", [](const Card& card) { return material::card_text(card.material); },
          "The card in SI units.")
      .def("as_model", &as_model, nb::arg("name"), "The same strengths on another yield surface.")
      .def_rw("file", &Card::file)
      .def_prop_ro("name", [](const Card& card) { return card.material.name; })
      .def_prop_ro("model",
                   [](const Card& card) { return std::string(material::model_name(card.material.model)); })
      .def_ro("sources", &Card::sources)
      .def_prop_ro(
          "density", [](const Card& card) { return card.material.density; }, "[kg/m^3]")
      .def_prop_ro(
          "E", [](const Card& card) { return material::initial_E(card.material.model); }, "[Pa]")
      .def_prop_ro("nu", [](const Card& card) { return material::initial_nu(card.material.model); })
      .def_prop_ro(
          "sigma_ref", [](const Card& card) { return material::reference_stress(card.material.model); },
          "The stress that makes forces dimensionless [Pa].")
      .def_prop_ro(
          "parameters",
          [](const Card& card) {
            std::vector<std::tuple<std::string, double, std::string>> list;
            for (const auto& p : material::parameters(card.material))
              list.emplace_back(p.key, p.value, p.meaning);
            return list;
          },
          "Key, value and meaning of each.");
  m.def("walk", &walk, nb::arg("material"), nb::arg("way"), nb::arg("rows"), nb::arg("strain"),
        nb::arg("lateral"), nb::arg("compaction"), nb::arg("steps"), nb::arg("moduli"), nb::arg("picture"),
        "States of a material point along a way.");
  m.def("read_strains", &material::read_strains, nb::arg("file"), "Columns eps_1, eps_2, eps_3 of a CSV.");
  m.attr("ways") = material::way_names();
  m.def("from_deck", &from_deck, nb::arg("file"), nb::arg("units"), nb::arg("name"), nb::arg("rho_r0").none(),
        nb::arg("despite_doubts"),
        "A card from an Abaqus deck; how it was read, what has no counterpart, what is doubted.");
  m.def("from_compaction", &from_compaction, nb::arg("test"), nb::arg("strengths"), nb::arg("rho_r0"),
        nb::arg("model"), nb::arg("name"),
        "A card from die compaction and tablet strengths, and how it was found.");
  m.def(
      "from_indices",
      [](double strain, double bonding, double hardness, double relative_density, const std::string& name) {
        const material::Material granule{
            name, surrogate::granule_from({strain, bonding, hardness, relative_density})};
        return material::read_card(core::parse_toml(material::card_text(granule), name));
      },
      nb::arg("strain"), nb::arg("bonding"), nb::arg("hardness"), nb::arg("relative_density"),
      nb::arg("name"), "A card from Hiestand's indices.");
  m.def("yield_from_heckel", &surrogate::yield_from_heckel, nb::arg("E"), nb::arg("nu"), nb::arg("pressure"));
  m.def("yield_from_hardness", &surrogate::yield_from_hardness, nb::arg("E"), nb::arg("nu"),
        nb::arg("hardness"), "[Pa]");
  m.def(
      "yield_from_crushing",
      [](double E, double nu, double force, double overlap, double radius) {
        return long_work([&] { return surrogate::yield_from_crushing(E, nu, force, overlap, radius); });
      },
      nb::arg("E"), nb::arg("nu"), nb::arg("force"), nb::arg("overlap"), nb::arg("radius"), "[Pa]");
  m.def("material_keys", &material::card_reference, "Every key of a material card, as Markdown.");
  m.def("study_keys", &study::study_reference, "Every key of a study card, as Markdown.");
  m.def("to_deck", &to_deck, nb::arg("material"), nb::arg("units"),
        "A section of an Abaqus deck, and what it lacks.");
  m.def(
      "predict", &predict, nb::arg("material"), nb::arg("law"), nb::arg("variant"), nb::arg("quick"),
      nb::arg("extrapolate"),
      "A law at once; what is to be read, the nearest materials that were pressed, and what else is known.");
}

} // namespace platen::python
