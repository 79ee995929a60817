#include "plot/measured/profile_picture.hpp"

#include "plot/axes.hpp"
#include "plot/gnuplot.hpp"

#include <fmt/format.h>

#include <cmath>

namespace platen::plot {

namespace {

constexpr const char *curve = "#0072b2", *level = "#d55e00", *parabola = "#8a949e"; // Okabe and Ito

struct Shown {
  std::string label;
  double unit = 1;
};
Shown shown(const std::string& key, double value) {
  if (!key.ends_with("_Pa")) return {key, 1};
  const Unit unit = unit_for(value, {{"GPa", 1e9}, {"MPa", 1e6}, {"kPa", 1e3}, {"Pa", 1}});
  return {fmt::format("{}  ({})", key.substr(0, key.size() - 3), unit.name), unit.in_SI};
}

} // namespace

void profile_picture(const calibrate::Calibration& c, const std::filesystem::path& file) {
  std::string data, panels;
  int count = 0;
  for (std::size_t k = 0; k < c.free.size(); ++k) {
    if (!c.profiles[k]) continue;
    const auto [label, unit] = shown(c.free[k].key, c.values[k]);
    data += fmt::format("$p{} << EOD\n", count);
    for (const auto& point : c.profiles[k]->points)
      data += fmt::format("{:.8g} {:.8g}\n", point.value / unit, point.deviance);
    data += "EOD\n";
    panels += fmt::format("set xlabel {} noenhanced tc rgb '{}'\n", gnuplot_string(label), ink);
    std::string more;
    if (const double error = c.errors[k]; std::isfinite(error) && error > 0)
      more =
          fmt::format(", (x - {0:.8g})**2/{1:.8g} with lines lw 1.5 dt 2 lc rgb '{2}' title 'standard error'",
                      c.values[k] / unit, std::pow(error / unit, 2), parabola);
    panels += fmt::format("plot {0} with lines lw 1 lc rgb '{1}' title '95 %'{2}, $p{3} using 1:2 with "
                          "linespoints lw 2 pt 7 ps 0.5 lc rgb '{4}' title 'profile'\n",
                          calibrate::deviance_95, level, more, count, curve);
    ++count;
  }
  const std::string script =
      terminal(file, 120 + 400 * count, 420) + data +
      fmt::format("set border 3 lc rgb '{0}'\nset tics nomirror out scale 0.5 tc rgb '{0}'\n"
                  "set grid lc rgb '#e3e7eb' lt 1 lw 1\nset key top center samplen 2 tc rgb '{0}'\n"
                  "set yrange [0:9]\nset samples 400\nset rmargin 5\nset xtics rotate by -30\n"
                  "set ylabel 'deviance  −2 ln(L/L_{{max}})' tc rgb '{0}'\nset multiplot layout 1,{1}\n",
                  ink, count) +
      panels + "unset multiplot\n";
  run_gnuplot(script, file);
}

} // namespace platen::plot
