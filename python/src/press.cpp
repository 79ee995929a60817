// Virtual presses, and the laws of their curves.

#include "core.hpp"

#include "fit/derivation.hpp"
#include "material/card.hpp"
#include "measure/as_measured.hpp"
#include "measure/fit_law.hpp"
#include "plot/press_folder.hpp"
#include "press/case_card.hpp"
#include "press/curve_csv.hpp"
#include "press/estimate.hpp"
#include "press/fields_vtu.hpp"
#include "press/press.hpp"
#include "press/summary.hpp"

#include <nanobind/ndarray.h>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace platen::python {
namespace {

struct Pressed {
  press::Case case_;
  press::Result result;
};

Pressed run(const std::string& case_text, const std::string& file, nb::object progress, bool estimate_error) {
  Pressed pressed{press::read_case(core::parse_toml(case_text, file)), {}};
  Callback callback(std::move(progress));
  const auto call = [&](double fraction, const press::CurvePoint& point) {
    return callback(fraction, point.delta_bar, point.force_N);
  };
  long_work([&] {
    auto& result = pressed.result;
    result = press::press(pressed.case_, call);
    if (estimate_error && !result.failure && !result.interrupted)
      result.error = press::estimate_error(pressed.case_, result, call);
  });
  callback.rethrow();
  return pressed;
}

template <class T, class List> nb::object matrix(const List& rows) {
  constexpr std::size_t columns = std::tuple_size_v<typename List::value_type>;
  auto* data = new T[rows.size() * columns];
  T* at = data;
  for (const auto& row : rows)
    for (const auto& value : row) *at++ = static_cast<T>(value);
  nb::capsule owner(data, [](void* p) noexcept { delete[] static_cast<T*>(p); });
  return nb::cast(nb::ndarray<nb::numpy, T, nb::ndim<2>>(data, {rows.size(), columns}, owner));
}

/// Components of stress, named as in files of VTK.
constexpr std::array section_stress{"sigma_rr_Pa", "sigma_zz_Pa", "sigma_rz_Pa", "sigma_tt_Pa"};
constexpr std::array spatial_stress{"sigma_xx_Pa", "sigma_yy_Pa", "sigma_zz_Pa",
                                    "sigma_xy_Pa", "sigma_yz_Pa", "sigma_zx_Pa"};

template <fe::Element E, class Names>
nb::dict fields(const press::SnapshotOf<E>& s, double radius_m, const Names& names) {
  nb::dict d;
  d["delta_bar"] = s.delta_bar;
  const auto in_metres = [&](auto points) {
    for (auto& point : points)
      for (auto& x : point) x *= radius_m;
    return points;
  };
  d["nodes_m"] = matrix<double>(in_metres(s.nodes));
  d["displacement_m"] = matrix<double>(in_metres(s.displacement));
  d["elements"] = matrix<std::int64_t>(s.elements);
  std::vector<std::array<int, 1>> zones;
  for (const auto& points : s.zones) zones.push_back({static_cast<int>(press::prevailing(points))});
  d["zone"] = matrix<std::uint8_t>(zones);
  for (std::size_t k = 0; k < names.size(); ++k) {
    std::vector<double> values;
    for (const auto& stress : s.stress) values.push_back(stress[k]);
    d[names[k]] = array_of(values);
  }
  d["p_Pa"] = array_of(s.p);
  d["q_Pa"] = array_of(s.q);
  d["rho_r"] = array_of(s.rho_r);
  d["phi"] = array_of(s.phi);
  d["plastic_hencky_strain_v"] = array_of(s.plastic_strain_v);
  d["plastic_hencky_strain_q"] = array_of(s.plastic_strain_q);
  return d;
}

nb::list all_fields(const Pressed& pressed) {
  nb::list list;
  for (const auto& snapshot : pressed.result.snapshots)
    list.append(fields(snapshot, pressed.case_.radius_m, section_stress));
  for (const auto& snapshot : pressed.result.spatial)
    list.append(fields(snapshot, pressed.case_.radius_m, spatial_stress));
  return list;
}

std::vector<std::pair<std::string, std::string>> vtu_files(const Pressed& pressed) {
  std::vector<std::pair<std::string, std::string>> files;
  const auto add = [&](const auto& snapshots) {
    for (const auto& s : snapshots)
      files.emplace_back(press::fields_name(s.delta_bar), press::fields_vtu(s, pressed.case_.radius_m));
    if (!snapshots.empty()) files.emplace_back("fields.pvd", press::fields_series(snapshots));
  };
  add(pressed.result.snapshots);
  add(pressed.result.spatial);
  return files;
}

std::optional<std::vector<double>> stop(const press::Result& result) {
  if (!result.error) return {};
  return std::vector{result.error->force, result.error->radius};
}

nb::tuple law_of(const Pressed& pressed, const std::string& law, const std::string& variant) {
  std::vector<std::string> said;
  const auto say = [&](const std::string& sentence) { said.push_back(sentence); };
  auto card = long_work([&] {
    const auto& result = pressed.result;
    if (law == "pressed" || law == "edmans-sinka") {
      auto laws = fit::derive_laws(result, variant, say);
      return law == "pressed" ? laws.pressed_card : laws.fitted_card;
    }
    measure::FitOptions options;
    options.law = law;
    return *measure::fit_law({pressed.case_.material.name, press::curve_csv(result.curve), result.curve},
                             options, say)
                .card;
  });
  return nb::make_tuple(std::move(card), said);
}

void save(const Pressed& pressed, const std::string& folder) {
  nb::gil_scoped_release free;
  plot::write_press(pressed.case_, pressed.result, core::OutputFolder(folder),
                    plot::Fields::pictures_and_vtu);
}

/// What `platen derive` leaves in its folder; what has to be read.
std::vector<std::string> save_derivation(const Pressed& pressed, const std::string& law,
                                         const std::string& variant, const std::string& path) {
  std::vector<std::string> said;
  long_work([&] {
    const auto& result = pressed.result;
    const core::OutputFolder folder(path);
    plot::write_press(pressed.case_, result, folder, plot::Fields::pictures);
    if (law == "wang") plot::write_law(result.curve, fit::fit_wang(result.curve), folder);
    else {
      const auto say = [&](const std::string& sentence) { said.push_back(sentence); };
      plot::write_laws(result.curve, fit::derive_laws(result, variant, say), law == "edmans-sinka", folder);
    }
  });
  return said;
}

std::string as_measured(const Pressed& pressed, int particles, double noise, double gap, double compliance,
                        std::int64_t seed) {
  const auto& c = pressed.case_;
  if (!std::holds_alternative<press::Simple>(c.experiment))
    throw core::InvalidInput(
        fmt::format("as_measured is for experiment = \"simple\", not \"{}\"", press::name_of(c.experiment)));
  if (particles < 1 || particles > 1000)
    throw core::InvalidInput(
        fmt::format("particles = {}: it must be a whole number in [1, 1000]", particles));
  for (const auto& [name, value, most] :
       {std::tuple{"noise", noise, 0.5}, {"gap", gap, 1e30}, {"compliance", compliance, 1e30}})
    if (!(value >= 0 && value <= most))
      throw core::InvalidInput(fmt::format("{} = {}: it must be a number in [0, {}]", name, value, most));
  if (seed < 0) throw core::InvalidInput(fmt::format("seed = {}: it must not be below 0", seed));
  const measure::Instrument instrument{.gap_m = gap, .noise = noise, .compliance_m_per_N = compliance};
  return measure::raw_text(measure::batch(pressed.result.curve, particles, 2 * c.radius_m, instrument,
                                          static_cast<std::uint64_t>(seed)));
}

std::string simple_case(const material::Card& card, double radius, double delta_bar_max,
                        std::optional<int> elements, const std::optional<std::vector<double>>& unload_from) {
  press::Simple e;
  e.delta_bar_max = delta_bar_max;
  if (elements) e.elements = *elements;
  return press::case_text(fit::simple_derivation(card.material, radius, e, unload_from));
}

std::string local_case(const material::Card& card, double radius, std::optional<double> delta_bar_max,
                       std::optional<double> force_max,
                       const std::optional<std::vector<double>>& unload_from) {
  return press::case_text(
      fit::local_derivation(card.material, radius, {delta_bar_max, force_max, unload_from}));
}

} // namespace

void add_press(nb::module_& m) {
  nb::class_<Pressed>(m, "Pressed", "What a press gave.")
      .def_prop_ro(
          "case", [](const Pressed& p) { return press::case_text(p.case_); }, "The resolved case card.")
      .def_prop_ro(
          "curve", [](const Pressed& p) { return press::curve_csv(p.result.curve); }, "curve.csv")
      .def_prop_ro(
          "summary", [](const Pressed& p) { return press::summary_json(p.case_, p.result); }, "summary.json")
      .def_prop_ro("flags", [](const Pressed& p) { return p.result.flags; })
      .def_prop_ro("failure", [](const Pressed& p) { return p.result.failure; })
      .def_prop_ro(
          "error", [](const Pressed& p) { return stop(p.result); },
          "Of force and contact radius against the limit of fine meshes, where it was asked for.")
      .def("fields", &all_fields, "One dictionary of arrays for each moment that was kept.")
      .def("vtu_files", &vtu_files, "Names and contents of the files of VTK.")
      .def("save", &save, nb::arg("folder"), "What `platen press` leaves in its folder, pictures included.")
      .def("save_derivation", &save_derivation, nb::arg("law"), nb::arg("variant"), nb::arg("folder"),
           "What `platen derive` leaves in its folder; what is to be read.")
      .def("as_measured", &as_measured, nb::arg("particles"), nb::arg("noise"), nb::arg("gap"),
           nb::arg("compliance"), nb::arg("seed"), "What an instrument would have written of it.")
      .def("law", &law_of, nb::arg("law"), nb::arg("variant"),
           "The card of a law of this curve, and what is to be read.");
  m.def("case_keys", &press::case_reference, "Every key of a case card, as Markdown.");
  m.def("press", &run, nb::arg("case_text"), nb::arg("file"), nb::arg("progress").none(),
        nb::arg("estimate_error"),
        "Presses a case; `progress` is called with the fraction done, delta/R and force after each step.");
  m.def("simple_case", &simple_case, nb::arg("material"), nb::arg("radius"), nb::arg("delta_bar_max"),
        nb::arg("elements").none(), nb::arg("unload_from").none(), "The press of `derive`.");
  m.def("local_case", &local_case, nb::arg("material"), nb::arg("radius"), nb::arg("delta_bar_max").none(),
        nb::arg("force_max").none(), nb::arg("unload_from").none(),
        "The press of `derive` for the law wang.");
  m.def(
      "parse_curve",
      [](const std::string& text, const std::string& file, std::optional<double> radius) {
        return press::curve_csv(press::parse_curve(text, file, radius));
      },
      nb::arg("text"), nb::arg("file"), nb::arg("radius").none(), "A curve as the press writes it.");
}

} // namespace platen::python
