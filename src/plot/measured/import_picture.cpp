#include "plot/measured/import_picture.hpp"

#include "plot/axes.hpp"
#include "plot/gnuplot.hpp"
#include "plot/measured/raw_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace platen::plot {

namespace {

/// A line each, in the corner of the panel.
std::string corrections(const measure::Measurement& m, const std::vector<measure::Stages>& stages,
                        const measure::Machine& machine) {
  std::vector<std::string> words;
  double most = 0;
  for (const auto& s : m.specimens) most = std::max(most, *std::ranges::max_element(s.force_N));
  if (m.specimens.size() == 1) {
    const auto& s = m.specimens.front();
    const auto& st = stages.front();
    words.push_back(fmt::format("contact at {} ± {:.2g}", s.on_scale_of_file(st.contact_travel_m),
                                st.contact_uncertainty_m / s.travel_unit.in_SI));
    words.push_back(st.baseline_rows > 0 ? fmt::format("zero of the load cell {:.2g} N", st.baseline_N)
                                         : "zero of the load cell not seen");
  } else words.push_back(fmt::format("contact and zero of each of {} particles", m.specimens.size()));
  words.push_back(machine.given()
                      ? fmt::format("machine: {:.3g} µm at {:.3g} N", machine.travel(most) * 1e6, most)
                      : "nothing for the machine");
  std::string labels;
  for (std::size_t i = 0; i < words.size(); ++i)
    labels += fmt::format("set label {} {} at graph 0.03,{:.3f} noenhanced tc rgb '{}'\n", i + 1,
                          gnuplot_string(words[i]), 0.96 - 0.055 * static_cast<double>(i), ink);
  return labels;
}

} // namespace

void import_picture(const measure::Measurement& m, const std::vector<measure::Stages>& stages,
                    const measure::Machine& machine, const std::filesystem::path& file) {
  std::vector<Staged> particles;
  bool sized = true;
  for (std::size_t k = 0; k < m.specimens.size(); ++k) {
    particles.push_back({&m.specimens[k], &stages[k]});
    sized = sized && m.specimens[k].diameter_m;
  }
  const auto panel = raw_panel(particles);
  std::string points;
  double force_most = 0;
  constexpr std::size_t drawn = 2000;
  for (const auto& [s, st] : particles) {
    if (st->broke) continue;
    const double R = sized ? s->radius_m() : 1e-6, area = sized ? std::numbers::pi * R * R * 1e6 : 1; // MPa
    const std::size_t stride = std::max<std::size_t>(1, s->force_N.size() / drawn);
    for (std::size_t i = 0; i < s->force_N.size(); i += stride) {
      const double F = s->force_N[i] - st->baseline_N;
      const double delta = s->per_travel() * (s->travel_m[i] - machine.travel(F) - st->contact_travel_m);
      points += fmt::format("{:.7g} {:.7g}\n", delta / R, F / area);
      force_most = std::max(force_most, F / area);
    }
    points += "\n";
  }
  const Unit unit =
      sized ? Unit{"MPa", 1} : unit_for(force_most, {{"kN", 1e3}, {"N", 1}, {"mN", 1e-3}, {"µN", 1e-6}});
  const std::string script =
      terminal(file, 1100, 520) + panel.data + data_block("points", points) + panel_style() +
      "set multiplot layout 1,2\n" + panel.commands + corrections(m, stages, machine) +
      fmt::format(
          "set title 'corrected by' tc rgb '{0}'\nset xlabel '{1}' tc rgb '{0}'\n"
          "set ylabel '{2}  ({3})' tc rgb '{0}'\nset xzeroaxis lc rgb '{0}'\n"
          "plot $points using 1:($2/{4}) with lines lw 1.5 lc rgb '#0072b2' notitle\nunset multiplot\n",
          ink, sized ? "overlap  δ/R" : "overlap  δ  (µm)", sized ? "F/(πR²)" : "force", unit.name,
          unit.in_SI);
  run_gnuplot(script, file);
}

} // namespace platen::plot
