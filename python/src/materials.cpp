// Material cards, and laws predicted from them.

#include "core.hpp"

#include "material/card.hpp"
#include "surrogate/predict_law.hpp"

namespace platen::python {
namespace {

using material::Card;

Card as_model(const Card& card, const std::string& name) {
  Card other = card;
  other.material.model = material::run_as(card.material.model, name);
  return other;
}

nb::tuple predict(const Card& card, const std::string& law, const std::string& variant, bool quick,
                  bool extrapolate) {
  std::vector<std::string> said;
  auto predicted = long_work([&] {
    return surrogate::predict_law(card.material, {law, variant, quick, extrapolate, card.file},
                                  [&](const std::string& sentence) { said.push_back(sentence); });
  });
  std::vector<std::string> near;
  for (const auto& one : predicted.near) near.push_back(words(predicted.answer.surrogate, one));
  return nb::make_tuple(std::move(predicted.card), said, near);
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
  m.def("predict", &predict, nb::arg("material"), nb::arg("law"), nb::arg("variant"), nb::arg("quick"),
        nb::arg("extrapolate"),
        "A law at once; what is to be read, and the nearest materials that were pressed.");
}

} // namespace platen::python
