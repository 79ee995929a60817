#include "plot/measured/measured_picture.hpp"

#include "measure/stages.hpp"
#include "plot/axes.hpp"
#include "plot/gnuplot.hpp"
#include "plot/measured/raw_curves.hpp"

#include <fmt/format.h>

#include <numbers>

namespace platen::plot {

namespace {

constexpr const char *law_colour = "#0072b2", *points_colour = "#8a949e"; // Okabe and Ito

} // namespace

void measured_picture(const std::vector<measure::Measurement>& measurements, const calibrate::Calibration& c,
                      const std::filesystem::path& file) {
  std::vector<measure::Stages> stages;
  std::vector<const measure::Specimen*> specimens;
  for (const auto& m : measurements)
    for (const auto& s : m.specimens) specimens.push_back(&s), stages.push_back(measure::stages_of(s));
  std::vector<Staged> particles;
  for (std::size_t k = 0; k < specimens.size(); ++k) particles.push_back({specimens[k], &stages[k]});
  const auto panel = raw_panel(particles);
  std::string points, law;
  for (const auto& p : c.particles) {
    const auto& s = p.samples;
    const double area = std::numbers::pi * s.radius_m * s.radius_m * 1e6; // MPa
    for (std::size_t i = 0; i < s.force_N.size(); ++i) {
      const double x = s.delta(i, p.contact_m) / s.radius_m;
      points += fmt::format("{:.7g} {:.7g}\n", x, p.measured_N(i) / area);
      law += fmt::format("{:.7g} {:.7g}\n", x, p.force_N[i] / area);
    }
    points += "\n", law += "\n";
  }
  const std::string script =
      terminal(file, 1100, 520) + panel.data + data_block("points", points) + data_block("law", law) +
      panel_style() + "set multiplot layout 1,2\n" + panel.commands +
      fmt::format("set title {1} noenhanced tc rgb '{0}'\nset xlabel 'overlap  δ/R' tc rgb '{0}'\n"
                  "set ylabel 'F/(πR²)  (MPa)' tc rgb '{0}'\n"
                  "plot $points with points pt 7 ps 0.5 lc rgb '{2}' title 'corrected', "
                  "$law with lines lw 1.2 lc rgb '{3}' title {4}\nunset multiplot\n",
                  ink,
                  gnuplot_string(fmt::format("corrected: {} of {} particles", c.particles.size(),
                                             c.particles.size() + c.broken.size())),
                  points_colour, law_colour,
                  gnuplot_string(fmt::format("law {}, R2 = {:.5f}", c.card.law, c.R2)));
  run_gnuplot(script, file);
}

} // namespace platen::plot
