#include "plot/measured/confined_prediction.hpp"

#include "plot/axes.hpp"
#include "plot/gnuplot.hpp"
#include "plot/measured/raw_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>

namespace platen::plot {

namespace {

struct Look {
  const char *colour, *title;
};
constexpr std::array looks = {Look{"#0072b2", "between two planes"}, Look{"#d55e00", "in a die"},
                              Look{"#009e73", "from all sides"}}; // Okabe and Ito

std::string panel(const char* value, const char* band, const std::string& more, std::size_t count) {
  std::string text = "plot " + more;
  for (std::size_t k = 0; k < count; ++k)
    text += fmt::format(
        "$c{0} using 1:{1} with filledcurves fs transparent solid 0.25 noborder lc rgb '{2}' notitle, "
        "$c{0} using 1:{3} with lines lw 1.8 lc rgb '{2}' title '{4}'{5}",
        k, band, looks[k].colour, value, looks[k].title, k + 1 < count ? ", " : "\n");
  return text;
}

} // namespace

void confined_prediction(const calibrate::Calibration& c, const std::vector<calibrate::ConfinedCurve>& curves,
                         const std::filesystem::path& file) {
  std::string data, points;
  double most = 0;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    std::string rows;
    for (std::size_t i = 0; i < curves[k].delta_bar.size(); ++i) {
      const auto &p = curves[k].pressure_Pa[i], &a = curves[k].a_bar[i];
      rows += fmt::format("{:.6g} {:.6g} {:.6g} {:.6g} {:.6g} {:.6g} {:.6g}\n", curves[k].delta_bar[i],
                          p.value / 1e6, p.low / 1e6, p.high / 1e6, a.value, a.low, a.high);
    }
    data += data_block(fmt::format("c{}", k), rows);
  }
  for (const auto& p : c.particles) {
    const double area = std::numbers::pi * p.samples.radius_m * p.samples.radius_m * 1e6; // MPa
    for (std::size_t i = 0; i < p.samples.force_N.size(); ++i) {
      points += fmt::format("{:.6g} {:.6g}\n", p.samples.delta(i, p.contact_m) / p.samples.radius_m,
                            p.measured_N(i) / area);
      most = std::max(most, p.measured_N(i) / area);
    }
  }
  // A full cell takes any force: the die is shown to twice what the planes alone would take at the end.
  const double top = 2 * std::max(most, curves.front().pressure_Pa.back().value / 1e6);
  const std::string script =
      terminal(file, 1100, 520) + data + data_block("points", points) + panel_style() +
      fmt::format("set multiplot layout 1,2\nset xrange [0:0.5]\nset yrange [0:{1:.6g}]\n"
                  "set title 'force, law {2}' tc rgb '{0}'\nset xlabel 'overlap  δ/R' tc rgb '{0}'\n"
                  "set ylabel 'F/(πR²)  (MPa)' tc rgb '{0}'\n",
                  ink, top, c.card.law) +
      panel("2", "3:4", "$points with points pt 7 ps 0.4 lc rgb '#8a949e' title 'measured', ",
            curves.size()) +
      fmt::format(
          "set title 'contact radius' tc rgb '{0}'\nset yrange [0:*]\nset ylabel 'a/R' tc rgb '{0}'\n", ink) +
      panel("5", "6:7", "", curves.size()) + "unset multiplot\n";
  run_gnuplot(script, file);
}

} // namespace platen::plot
