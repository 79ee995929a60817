#include "plot/energy_picture.hpp"

#include "core/error.hpp"
#include "plot/axes.hpp"
#include "plot/gnuplot.hpp"
#include "press/regimes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace platen::plot {

void energy_picture(const press::Curve& curve, const std::filesystem::path& file) {
  const double unit = std::numbers::pi * std::pow(curve.radius_m, 3) * curve.sigma_ref_Pa;
  std::string data;
  double least_x = 0, most_x = 0, least = 0, most = 0, peak = 0;
  for (const auto& p : curve.points) {
    if (p.branch != press::Branch::loading || !(p.work_J > 0) || !(p.delta_bar > 0)) continue;
    if (data.empty()) least_x = 0.6 * p.delta_bar, least = p.work_J / unit;
    most_x = std::max(most_x, p.delta_bar);
    most = std::max(most, p.work_J / unit);
    peak = std::max(peak, p.mean_pressure_Pa / curve.sigma_ref_Pa);
    const auto energy = [&](double joule) {
      return joule > 0 ? fmt::format("{:.8g}", joule / unit) : std::string("NaN"); // no place on a log axis
    };
    data += fmt::format("{:.8g} {:.8g} {} {} {}\n", p.delta_bar, p.mean_pressure_Pa / curve.sigma_ref_Pa,
                        energy(p.work_J), energy(p.stored_J), energy(p.dissipated_J));
  }
  if (data.empty()) throw core::InvalidInput("no work is done, so there is nothing to draw");
  const auto regimes = press::regimes(curve);
  std::string script =
      terminal(file, 860, 800) + fmt::format("$curve << EOD\n{}EOD\n", data) +
      fmt::format(
          "set border 3 lc rgb '{0}' lw 1\nset tics nomirror out scale 0.5 tc rgb '{0}'\n"
          "set grid xtics ytics lc rgb '#e3e7eb' lt 1 lw 1\nset lmargin at screen 0.13\n"
          "set rmargin at screen 0.96\nset logscale x\nset format x '%g'\nset xrange [{1:.8g}:{2:.8g}]\n"
          "set multiplot\n",
          ink, least_x, 1.05 * most_x);
  const auto& boundaries = press::regime_boundaries();
  double from = least_x;
  std::string name = "elastic", marks;
  int tag = 1;
  const auto named = [&](double to) { // upright: a regime can be narrow
    marks += fmt::format("set label {} {} at {:.8g},graph 0.03 rotate by 90 left tc rgb '#5b6670'\n", tag++,
                         gnuplot_string(name), std::sqrt(from * std::max(from, to)));
  };
  int arrows = 0;
  for (const auto& boundary : boundaries) {
    const auto& at = regimes.*boundary.delta_bar;
    if (!at) continue;
    if (*at > from) named(*at);
    marks += fmt::format(
        "set arrow {} from {:.8g},graph 0 to {:.8g},graph 1 nohead dt 2 lw 1.4 lc rgb '#5b6670'\n", ++arrows,
        *at, *at);
    from = *at;
    name = boundary.name;
  }
  named(most_x);
  script +=
      marks +
      fmt::format("set tmargin at screen 0.945\nset bmargin at screen 0.60\nset yrange [0:{:.8g}]\n"
                  "set title {} noenhanced tc rgb '{}'\nset ylabel 'mean pressure/σ_{{ref}}' tc rgb '{}'\n"
                  "plot $curve using 1:2 with lines lw 2.2 lc rgb '#0072b2' notitle\n",
                  1.1 * peak,
                  gnuplot_string(fmt::format("{}, {}, R₀ = {:.4g} mm", curve.material, curve.experiment,
                                             1e3 * curve.radius_m)),
                  ink, ink);
  for (int i = 1; i < tag; ++i) script += fmt::format("unset label {}\n", i); // once is enough
  script +=
      fmt::format("unset title\nset tmargin at screen 0.52\nset bmargin at screen 0.09\nset logscale y\n"
                  "set format y '10^{{%L}}'\nset yrange [{:.8g}:{:.8g}]\nset key at screen 0.96,screen 0.555 "
                  "right top horizontal Left reverse "
                  "samplen 2 tc rgb '{}'\n"
                  "set xlabel 'overlap of the planes along z  δ/R_0' tc rgb '{}'\n"
                  "set ylabel 'energy of one side W/(πR_0^3σ_{{ref}})' tc rgb '{}'\n"
                  "plot $curve using 1:3 with lines lw 2.6 lc rgb '#0072b2' title 'work', "
                  "$curve using 1:4 with lines lw 2.2 lc rgb '#009e73' title 'stored', "
                  "$curve using 1:5 with lines lw 2.2 lc rgb '#d55e00' title 'dissipated'\nunset multiplot\n",
                  least, 2 * most, ink, ink, ink);
  run_gnuplot(script, file);
}

} // namespace platen::plot
