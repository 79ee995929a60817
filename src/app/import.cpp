#include "app/commands.hpp"
#include "app/measured_arguments.hpp"
#include "core/file.hpp"
#include "measure/curve_text.hpp"
#include "plot/gnuplot.hpp"
#include "plot/measured/import_picture.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace platen::app {
namespace {

struct Options {
  std::string raw, output, picture;
  MeasuredArguments measured;
  bool json = false;
};

std::string words_of(const measure::Measurement& m, const std::vector<measure::Stages>& stages,
                     const measure::Machine& machine) {
  std::string text = fmt::format("{}: {}\n", m.file, m.read_as);
  for (const auto& sentence : m.said) text += fmt::format("  {}\n", sentence);
  for (std::size_t k = 0; k < m.specimens.size(); ++k) {
    const auto& s = m.specimens[k];
    const auto& st = stages[k];
    text += fmt::format("{}: {}, {} rows from line {} on; {}\n", s.name,
                        s.diameter_m ? fmt::format("d = {:.4g} mm", *s.diameter_m * 1e3)
                                     : "diameter not in the file",
                        s.force_N.size(), s.first_line, st.words());
    text += fmt::format("  force begins at {} +- {:.2g}{}\n", s.on_scale_of_file(st.contact_travel_m),
                        st.contact_uncertainty_m / s.travel_unit.in_SI,
                        st.baseline_rows > 0 ? fmt::format(", load cell zero {:.3g} N of {} rows",
                                                           st.baseline_N, st.baseline_rows)
                                             : "; no row before contact shows the zero of the load cell");
    if (st.broke)
      text += fmt::format("  broken: line {}, the force fell by {:.0f} % while the platens closed\n",
                          s.line[st.broke->row], 100 * st.broke->fell);
  }
  return text + (machine.given() ? fmt::format("machine: {}\n", machine.said)
                                 : "machine: no compliance taken off the travel\n");
}

std::string json_of(const measure::Measurement& m, const std::vector<measure::Stages>& stages,
                    const measure::Machine& machine) {
  nlohmann::ordered_json particles = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < m.specimens.size(); ++k) {
    const auto& s = m.specimens[k];
    const auto& st = stages[k];
    nlohmann::ordered_json p = {{"name", s.name},
                                {"rows", s.force_N.size()},
                                {"line", s.first_line},
                                {"contact_travel_m", st.contact_travel_m},
                                {"contact_uncertainty_m", st.contact_uncertainty_m},
                                {"holds", st.holds},
                                {"loops", st.loops},
                                {"unloadings", st.unloadings},
                                {"broken", st.broke.has_value()}};
    if (s.diameter_m) p["diameter_m"] = *s.diameter_m;
    particles.push_back(std::move(p));
  }
  const nlohmann::ordered_json json = {{"file", m.file},          {"sha256", m.sha256},
                                       {"read_as", m.read_as},    {"found", m.said},
                                       {"machine", machine.said}, {"particles", particles}};
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void import(const Options& o) {
  if (!o.picture.empty()) (void)plot::format_of(o.picture);
  const auto m = measurements_of({o.raw}, o.measured).front();
  const auto machine = machine_of(o.measured);
  std::vector<measure::Stages> stages;
  for (const auto& s : m.specimens) stages.push_back(measure::stages_of(s));
  if (!o.output.empty()) core::write_file(o.output, measure::curve_text(m, stages, machine));
  if (!o.picture.empty()) plot::import_picture(m, stages, machine, o.picture);
  fmt::print(report_stream(o.output), "{}",
             o.json ? json_of(m, stages, machine) : words_of(m, stages, machine));
}

} // namespace

void add_import(Command program) {
  auto command = program.add_subcommand("import", "read a file of an instrument, and say what is in it");
  auto o = std::make_shared<Options>();
  command.add_option("RAW", o->raw, "file of a testing machine: text in columns, as it was exported")
      .required();
  command.add_option("-o", o->output, "write particle, diameter_m, time_s, travel_m, force_N, branch here")
      .type_name("CURVE.csv");
  command
      .add_option("--picture", o->picture,
                  "draw what was measured, what was found in it, and what is left corrected: .svg or .png")
      .type_name("FILE");
  add_measured_arguments(command, o->measured, false);
  command.add_flag("--json", o->json, "for a machine to read");
  command.footer("Displacement is the way between the platens, 2 delta, unless --displacement-is contact.\n"
                 "Example: platen import granule.txt -o curve.csv\n"
                 "         platen import raw.csv --force F:N --displacement s:mm --radius_m 0.6e-3");
  command.callback([o] { import(*o); });
}

} // namespace platen::app
