// What instruments measured: import, fit, calibrate.

#include "core.hpp"

#include "calibrate/calibration.hpp"
#include "calibrate/free_parameters.hpp"
#include "measure/curve_text.hpp"
#include "measure/fit_law.hpp"
#include "measure/stages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace platen::python {
namespace {

using Number = std::optional<double>;

measure::ReadOptions read_options(const std::string& force, const std::string& displacement,
                                  const std::string& displacement_is, Number diameter) {
  return {force, displacement, displacement_is, diameter};
}

nb::dict import_curve(const std::string& file, const measure::ReadOptions& read, Number compliance,
                      const std::string& empty_machine) {
  std::vector<measure::Stages> stages;
  const auto [m, machine] = long_work([&] {
    auto measurement = measure::read_measurement(file, read);
    for (const auto& s : measurement.specimens) stages.push_back(measure::stages_of(s));
    return std::pair{std::move(measurement), measure::machine_of(compliance, empty_machine, read)};
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
              Number inverse_m, bool despite_doubts) {
  std::vector<std::string> said;
  auto fitting = long_work([&] {
    const measure::CurveOptions how{read, measure::machine_of(compliance, empty_machine, read),
                                    despite_doubts};
    const auto input =
        curve_text.empty() ? measure::read_curve(file, how) : measure::read_curve(file, curve_text, how);
    const measure::FitOptions options{law,     variant,   sigma_ref,      E,   nu, phi,
                                      sigma_c, inverse_m, despite_doubts, true};
    return measure::fit_law(input, options, [&](const std::string& sentence) { said.push_back(sentence); });
  });
  for (const auto& doubt : fitting.doubts) said.push_back("doubted: " + doubt);
  return nb::make_tuple(*fitting.card, said);
}

nb::dict calibrate(const std::vector<std::string>& files, const std::vector<measure::ReadOptions>& reads,
                   Number compliance, const std::string& empty_machine, const std::string& law,
                   const std::string& variant, const law::ParameterTexts& given, bool despite_doubts) {
  std::vector<std::string> flags;
  auto c = long_work([&] {
    std::vector<measure::Measurement> measurements;
    for (std::size_t i = 0; i < files.size(); ++i)
      measurements.push_back(measure::read_measurement(files[i], reads[i]));
    calibrate::Settings settings{law, variant, given,
                                 measure::machine_of(compliance, empty_machine, reads.at(0))};
    auto found = calibrate::calibrate(measurements, settings);
    flags = fit::pass(found.doubts, despite_doubts);
    if (!flags.empty())
      found.card.provenance.emplace_back("doubts", fmt::format("{}", fmt::join(flags, "; ")));
    return found;
  });
  nb::dict values, errors;
  for (std::size_t k = 0; k < c.free.size(); ++k) {
    values[c.free[k].key.c_str()] = c.values[k];
    errors[c.free[k].key.c_str()] = c.errors[k];
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
  d["parameters"] = values;
  d["standard_errors"] = errors;
  d["correlations"] = c.correlations;
  d["R2"] = c.R2;
  d["delta_bar_max"] = c.delta_bar_max;
  d["particles"] = particles;
  d["broken"] = c.broken;
  d["remarks"] = c.said;
  d["doubts"] = flags;
  d["words"] = words_of(c);
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
        nb::arg("empty_machine"), "What is in a file of an instrument.");
  m.def("fit", &fit, nb::arg("file"), nb::arg("curve_text"), nb::arg("read"), nb::arg("compliance").none(),
        nb::arg("empty_machine"), nb::arg("law"), nb::arg("variant"), nb::arg("sigma_ref").none(),
        nb::arg("E").none(), nb::arg("nu").none(), nb::arg("phi").none(), nb::arg("sigma_c").none(),
        nb::arg("inverse_m").none(), nb::arg("despite_doubts"),
        "The card of a law fitted to a curve, and what is to be read.");
  m.def("calibrate", &calibrate, nb::arg("files"), nb::arg("reads"), nb::arg("compliance").none(),
        nb::arg("empty_machine"), nb::arg("law"), nb::arg("variant"), nb::arg("given"),
        nb::arg("despite_doubts"), "A law from measured particles.");
  m.attr("calibrated_laws") = calibrate::calibrated_laws();
}

} // namespace platen::python
