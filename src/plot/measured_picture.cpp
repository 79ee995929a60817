#include "plot/measured_picture.hpp"

#include "measure/stages.hpp"
#include "plot/axes.hpp"
#include "plot/gnuplot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace platen::plot {
namespace {

constexpr const char *used = "#0072b2", *before = "#8a949e", *cut = "#d55e00"; // Okabe and Ito

/// Rows as they were measured, in three blocks; an empty line parts particles and stages.
struct Raw {
  std::string used, before, cut;
  double travel_most = 0, force_most = 0;
};

Raw raw(const std::vector<measure::Measurement>& measurements) {
  constexpr std::size_t drawn = 2000; // rows of a particle
  Raw r;
  for (const auto& m : measurements)
    for (const auto& s : m.specimens) {
      const auto stages = measure::stages_of(s);
      const std::size_t stride = std::max<std::size_t>(1, s.force_N.size() / drawn);
      for (std::size_t i = 0; i < s.force_N.size(); i += stride) {
        const auto stage = stages.of_row[i];
        std::string& block = stages.broke ? r.cut : stage == measure::Stage::approach ? r.before : r.used;
        block += fmt::format("{:.7g} {:.7g}\n", s.travel_m[i] * 1e6, s.force_N[i]);
        r.travel_most = std::max(r.travel_most, s.travel_m[i] * 1e6);
        r.force_most = std::max(r.force_most, s.force_N[i]);
      }
      for (auto* block : {&r.used, &r.before, &r.cut}) *block += "\n";
    }
  return r;
}

} // namespace

void measured_picture(const std::vector<measure::Measurement>& measurements, const calibrate::Calibration& c,
                      const std::filesystem::path& file) {
  const Raw r = raw(measurements);
  const Unit force = unit_for(r.force_most, {{"kN", 1e3}, {"N", 1}, {"mN", 1e-3}, {"µN", 1e-6}});
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
  // A file without such rows still needs a point for gnuplot.
  const auto block = [](const char* name, const std::string& rows) {
    return fmt::format("${} << EOD\n{}EOD\n", name,
                       rows.find_first_not_of('\n') == rows.npos ? "NaN NaN\n" : rows);
  };
  const std::string script =
      terminal(file, 1100, 520) + block("used", r.used) + block("before", r.before) + block("cut", r.cut) +
      block("points", points) + block("law", law) +
      fmt::format("set border 3 lc rgb '{0}'\nset tics nomirror out scale 0.5 tc rgb '{0}'\n"
                  "set grid lc rgb '#e3e7eb' lt 1 lw 1\nset key left top Left reverse noenhanced samplen 2 "
                  "tc rgb '{0}'\n"
                  "set multiplot layout 1,2\nset title 'as measured' tc rgb '{0}'\n"
                  "set xlabel 'travel, sign turned where it was  (µm)' tc rgb '{0}'\nset ylabel 'force "
                  "({1})' tc rgb '{0}'\n"
                  "plot $used using 1:($2/{2}) with lines lw 1.5 lc rgb '{3}' title 'used', "
                  "$before using 1:($2/{2}) with lines lw 1.5 lc rgb '{4}' title 'before contact', "
                  "$cut using 1:($2/{2}) with lines lw 1.5 lc rgb '{5}' title 'broken: kept out'\n",
                  ink, force.name, force.in_SI, used, before, cut) +
      fmt::format("set title {1} noenhanced tc rgb '{0}'\nset xlabel 'overlap  δ/R' tc rgb '{0}'\n"
                  "set ylabel 'F/(πR²)  (MPa)' tc rgb '{0}'\n"
                  "plot $points with points pt 7 ps 0.5 lc rgb '{2}' title 'corrected', "
                  "$law with lines lw 1.2 lc rgb '{3}' title {4}\nunset multiplot\n",
                  ink,
                  gnuplot_string(fmt::format("corrected: {} of {} particles", c.particles.size(),
                                             c.particles.size() + c.broken.size())),
                  before, used, gnuplot_string(fmt::format("law {}, R2 = {:.5f}", c.card.law, c.R2)));
  run_gnuplot(script, file);
}

} // namespace platen::plot
