// What instruments measured: import, fit, calibrate.

#include "study.hpp"

#include "calibrate/calibration.hpp"
#include "calibrate/confined.hpp"
#include "calibrate/free_parameters.hpp"
#include "core/file.hpp"
#include "measure/curve_text.hpp"
#include "measure/fit_law.hpp"
#include "measure/stages.hpp"
#include "plot/gnuplot.hpp"
#include "plot/measured/confined_prediction.hpp"
#include "plot/measured/fitting_picture.hpp"
#include "plot/measured/import_picture.hpp"
#include "plot/measured/measured_picture.hpp"
#include "plot/measured/profile_picture.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace platen::python {
namespace {

using Number = std::optional<double>;

/// Before any work: InvalidInput for the name of a file that is no picture.
void check_pictures(std::initializer_list<std::string> files) {
  for (const auto& file : files)
    if (!file.empty()) (void)plot::format_of(file);
}

measure::ReadOptions read_options(const std::string& force, const std::string& displacement,
                                  const std::string& displacement_is, Number diameter) {
  return {force, displacement, displacement_is, diameter};
}

nb::dict import_curve(const std::string& file, const measure::ReadOptions& read, Number compliance,
                      const std::string& empty_machine, const std::string& picture) {
  check_pictures({picture});
  std::vector<measure::Stages> stages;
  const auto [m, machine] = long_work([&] {
    auto measurement = measure::read_measurement(file, read);
    for (const auto& s : measurement.specimens) stages.push_back(measure::stages_of(s));
    auto given = measure::machine_of(compliance, empty_machine, read);
    if (!picture.empty()) plot::import_picture(measurement, stages, given, picture);
    return std::pair{std::move(measurement), std::move(given)};
  });
  nb::list particles;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const auto& s = m.specimens[i];
    const auto& found = stages[i];
    nb::dict p;
    p["name"] = s.name;
    p["diameter_m"] = s.diameter_m;
    p["rows"] = s.force_N.size();
    p["contact_travel_m"] = found.contact_travel_m;
    p["contact_uncertainty_m"] = found.contact_uncertainty_m;
    p["words"] = found.words();
    p["broken"] = found.broke.has_value();
    particles.append(p);
  }
  nb::dict d;
  d["file"] = m.file;
  d["sha256"] = m.sha256;
  d["read_as"] = m.read_as;
  d["found"] = m.said;
  d["machine"] = machine.said;
  d["particles"] = particles;
  d["text"] = measure::curve_text(m, stages, machine);
  return d;
}

nb::tuple fit(const std::string& file, const std::string& curve_text, const measure::ReadOptions& read,
              Number compliance, const std::string& empty_machine, const std::string& law,
              const std::string& variant, Number sigma_ref, Number E, Number nu, Number phi, Number sigma_c,
              Number inverse_m, bool despite_doubts, const std::string& picture) {
  check_pictures({picture});
  if (!picture.empty()) plot::check_fitting_picture(law);
  std::vector<std::string> said;
  auto fitting = long_work([&] {
    const measure::CurveOptions how{read, measure::machine_of(compliance, empty_machine, read),
                                    despite_doubts};
    const auto input =
        curve_text.empty() ? measure::read_curve(file, how) : measure::read_curve(file, curve_text, how);
    const measure::FitOptions options{law,     variant,   sigma_ref,      E,   nu, phi,
                                      sigma_c, inverse_m, despite_doubts, true};
    auto fitted =
        measure::fit_law(input, options, [&](const std::string& sentence) { said.push_back(sentence); });
    if (!picture.empty()) plot::fitting_picture(fitted, picture);
    return fitted;
  });
  for (const auto& doubt : fitting.doubts) said.push_back("doubted: " + doubt);
  return nb::make_tuple(*fitting.card, said);
}

/// What a calibration is asked beside its files.
struct Wish {
  std::string law, variant, material; ///< a law, or a material is looked for
  law::ParameterTexts given;
  std::vector<std::string> free;
  bool by_presses = false;
  std::string store;
  int workers = 0;
  bool profiles = false, confined = false, despite_doubts = false;
  std::map<std::string, std::vector<double>> asked;          ///< sets of what is free, a column each
  std::string picture, profiles_picture, confined_file = {}; ///< drawn, or .csv
};

std::vector<std::vector<double>> rows_of(const std::map<std::string, std::vector<double>>& columns,
                                         const std::vector<calibrate::FreeParameter>& free) {
  std::vector<std::vector<double>> rows;
  for (const auto& [key, values] : columns) {
    if (std::ranges::find(free, key, &calibrate::FreeParameter::key) == free.end())
      throw core::InvalidInput(fmt::format("asked: {} is not looked for", key));
    if (values.size() != columns.begin()->second.size())
      throw core::InvalidInput(fmt::format("asked: {} has {} numbers, {} has {}", key, values.size(),
                                           columns.begin()->first, columns.begin()->second.size()));
  }
  if (columns.empty()) return rows;
  rows.resize(columns.begin()->second.size());
  for (const auto& parameter : free) {
    const auto found = columns.find(parameter.key);
    if (found == columns.end())
      throw core::InvalidInput(fmt::format("asked: there is no {}, which is looked for", parameter.key));
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].push_back(found->second[i]);
  }
  return rows;
}

calibrate::Settings settings_of(const Wish& w, measure::Machine machine) {
  calibrate::Settings settings{w.law, w.variant, w.given, std::move(machine), w.profiles};
  if (!w.material.empty())
    settings.material = std::make_shared<calibrate::FreeMaterial>(w.material, w.given, w.free);
  else (void)calibrate::free_law(w.law);
  settings.asked = rows_of(w.asked, calibrate::free_parameters(settings));
  return settings;
}

nb::object dict_of(const std::optional<calibrate::Profile>& profile) {
  if (!profile) return nb::none();
  std::vector<double> values, deviances;
  for (const auto& point : profile->points)
    values.push_back(point.value), deviances.push_back(point.deviance);
  nb::dict d;
  d["low"] = profile->open_low ? nb::none() : nb::cast(profile->low);
  d["high"] = profile->open_high ? nb::none() : nb::cast(profile->high);
  d["value"] = array_of(values);
  d["deviance"] = array_of(deviances);
  return d;
}

nb::list list_of(const std::vector<calibrate::ConfinedCurve>& curves) {
  const auto banded = [](const std::vector<calibrate::Banded>& values, nb::dict& d, const std::string& name) {
    std::vector<double> value, low, high;
    for (const auto& v : values) value.push_back(v.value), low.push_back(v.low), high.push_back(v.high);
    d[name.c_str()] = array_of(value);
    d[(name + "_low").c_str()] = array_of(low);
    d[(name + "_high").c_str()] = array_of(high);
  };
  nb::list list;
  for (const auto& c : curves) {
    nb::dict d;
    d["loading"] = c.loading;
    d["delta_bar"] = array_of(c.delta_bar);
    banded(c.pressure_Pa, d, "F_over_pi_R2_Pa");
    banded(c.a_bar, d, "a_bar");
    list.append(d);
  }
  return list;
}

nb::list list_of(const std::vector<calibrate::Told>& told) {
  nb::list list;
  for (const auto& t : told) {
    nb::list forces;
    for (const auto& particle : t.force_N) forces.append(array_of(particle));
    list.append(nb::make_tuple(t.values, t.deviance, t.R2, t.relative_l2, forces));
  }
  return list;
}

/// The card of the material that was found, with what is known of each number under [source].
nb::object material_of(const calibrate::Calibration& c, const std::vector<std::string>& doubts) {
  if (!c.material) return nb::none();
  return nb::cast(
      material::read_card(core::parse_toml(calibrate::material_card(c, doubts), "the calibrated material")));
}

nb::dict dict_of(const calibrate::Calibration& c, const std::vector<std::string>& doubts) {
  nb::dict values, errors, noise, profiles;
  std::vector<std::string> free;
  for (std::size_t k = 0; k < c.free.size(); ++k) {
    const char* key = c.free[k].key.c_str();
    values[key] = c.values[k];
    errors[key] = c.errors[k];
    noise[key] = c.noise_errors[k];
    if (c.profiles[k]) profiles[key] = dict_of(c.profiles[k]);
    free.push_back(c.free[k].key);
  }
  nb::list particles;
  for (const auto& p : c.particles) {
    nb::dict one;
    one["name"] = p.name;
    one["file"] = p.file;
    one["diameter_m"] = p.diameter_m;
    one["rows"] = p.rows;
    one["contact_travel_m"] = p.contact_m;
    one["contact_standard_error_m"] = p.contact_error_m;
    one["R2"] = p.R2;
    one["values"] = p.values;
    particles.append(one);
  }
  nb::dict d;
  d["card"] = c.card;
  d["material"] = material_of(c, doubts);
  d["parameters"] = values;
  d["standard_errors"] = errors;
  d["standard_errors_of_noise"] = noise;
  d["profiles"] = profiles;
  d["correlations"] = c.correlations;
  d["R2"] = c.R2;
  d["delta_bar_max"] = c.delta_bar_max;
  d["particles"] = particles;
  d["broken"] = c.broken;
  d["remarks"] = c.said;
  d["doubts"] = doubts;
  d["words"] = words_of(c);
  d["free"] = free;
  d["told"] = list_of(c.told);
  return d;
}

nb::dict calibrate(const std::vector<std::string>& files, const std::vector<measure::ReadOptions>& reads,
                   Number compliance, const std::string& empty_machine, const Wish& w, nb::object progress) {
  const bool table = w.confined_file.ends_with(".csv");
  check_pictures({w.picture, w.profiles_picture, table ? "" : w.confined_file});
  const int workers = processes(w.workers);
  Callback callback(std::move(progress));
  std::vector<std::string> doubts;
  std::vector<calibrate::ConfinedCurve> confined;
  auto c = watched(callback, [&] {
    const auto settings = settings_of(w, measure::machine_of(compliance, empty_machine, reads.at(0)));
    std::vector<measure::Measurement> measured;
    for (std::size_t i = 0; i < files.size(); ++i)
      measured.push_back(measure::read_measurement(files[i], reads[i]));
    auto found = [&] {
      if (!w.by_presses)
        return settings.material ? calibrate::calibrate_material(measured, settings)
                                 : calibrate::calibrate(measured, settings);
      study::Store store(w.store, "calibration");
      store.open_for_writing(study::OldRuns::recompute);
      return calibrate::calibrate_material_by_presses(
          measured, settings,
          {store, workers, [&](const std::string& sentence) { (void)callback(sentence); }});
    }();
    if (!w.picture.empty())
      plot::measured_picture(measured, found, w.picture); // also of what is refused then
    if (!w.profiles_picture.empty()) plot::profile_picture(found, w.profiles_picture);
    doubts = fit::pass(found.doubts, w.despite_doubts);
    if (!doubts.empty())
      found.card.provenance.emplace_back("doubts", fmt::format("{}", fmt::join(doubts, "; ")));
    if (w.confined) confined = calibrate::confined(found);
    if (table) core::write_file(w.confined_file, calibrate::confined_csv(confined));
    else if (!w.confined_file.empty()) plot::confined_prediction(found, confined, w.confined_file);
    return found;
  });
  auto d = dict_of(c, doubts);
  d["confined"] = list_of(confined);
  return d;
}

} // namespace

void add_measured(nb::module_& m) {
  nb::class_<measure::ReadOptions>(m, "ReadOptions", "What a file of an instrument does not say.")
      .def(
          "__init__",
          [](measure::ReadOptions* self, const std::string& force, const std::string& displacement,
             const std::string& displacement_is, Number diameter) {
            new (self) measure::ReadOptions(read_options(force, displacement, displacement_is, diameter));
          },
          nb::arg("force"), nb::arg("displacement"), nb::arg("displacement_is"), nb::arg("diameter").none());
  m.def("import_curve", &import_curve, nb::arg("file"), nb::arg("read"), nb::arg("compliance").none(),
        nb::arg("empty_machine"), nb::arg("picture"), "What is in a file of an instrument.");
  m.def("fit", &fit, nb::arg("file"), nb::arg("curve_text"), nb::arg("read"), nb::arg("compliance").none(),
        nb::arg("empty_machine"), nb::arg("law"), nb::arg("variant"), nb::arg("sigma_ref").none(),
        nb::arg("E").none(), nb::arg("nu").none(), nb::arg("phi").none(), nb::arg("sigma_c").none(),
        nb::arg("inverse_m").none(), nb::arg("despite_doubts"), nb::arg("picture"),
        "The card of a law fitted to a curve, and what is to be read.");
  nb::class_<Wish>(m, "Wish", "What a calibration is asked beside its files.")
      .def(nb::init<>())
      .def_rw("law", &Wish::law)
      .def_rw("variant", &Wish::variant)
      .def_rw("material", &Wish::material)
      .def_rw("given", &Wish::given)
      .def_rw("free", &Wish::free)
      .def_rw("by_presses", &Wish::by_presses)
      .def_rw("store", &Wish::store)
      .def_rw("workers", &Wish::workers)
      .def_rw("profiles", &Wish::profiles)
      .def_rw("confined", &Wish::confined)
      .def_rw("despite_doubts", &Wish::despite_doubts)
      .def_rw("asked", &Wish::asked)
      .def_rw("picture", &Wish::picture)
      .def_rw("profiles_picture", &Wish::profiles_picture)
      .def_rw("confined_file", &Wish::confined_file);
  m.def("calibrate", &calibrate, nb::arg("files"), nb::arg("reads"), nb::arg("compliance").none(),
        nb::arg("empty_machine"), nb::arg("wish"), nb::arg("progress").none(),
        "A law, or a material, from measured particles.");
  std::vector<std::string> models, parameters;
  material::for_each_model([&]<class M>() {
    models.emplace_back(M::name);
    for (const auto& field : M::card().fields) parameters.push_back(field.key);
  });
  m.attr("material_models") = models;
  m.attr("material_parameters") = parameters;
  m.attr("calibrated_laws") = calibrate::calibrated_laws();
}

} // namespace platen::python
