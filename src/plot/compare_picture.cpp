#include "plot/compare_picture.hpp"

#include "plot/axes.hpp"
#include "plot/gnuplot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace platen::plot {
namespace {

// Okabe and Ito, jfly.uni-koeln.de/color; the reference is black
constexpr std::array colours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#7f6a3f"};

/// Points where `wanted(i)` or a neighbour holds, an empty line in the gaps; `value(i)` in the second column.
template <class Value, class Wanted>
std::string block(const std::string& name, const fit::Reference& r, Value value, Wanted wanted) {
  std::string text = fmt::format("${} << EOD\n", name);
  for (std::size_t i = 0; i < r.delta.size(); ++i) {
    const bool here = wanted(i) || (i > 0 && wanted(i - 1));
    if (here && std::isfinite(value(i)))
      text += fmt::format("{:.8g} {:.8g}\n", r.delta[i] / r.radius_m, value(i));
    else text += '\n';
  }
  return text + "EOD\n";
}

} // namespace

void compare_picture(const fit::Reference& reference, const std::vector<fit::Trace>& traces,
                     const std::string& title, const std::filesystem::path& file) {
  double F_max = 0;
  for (double F : reference.trace.force) F_max = std::max(F_max, F);
  const Unit unit =
      unit_for(F_max, {{"MN", 1e6}, {"kN", 1e3}, {"N", 1}, {"mN", 1e-3}, {"µN", 1e-6}, {"nN", 1e-9}});
  const double x_max = reference.delta.back() / reference.radius_m;
  std::string script = terminal(file, 1000, 720);
  const auto everywhere = [](std::size_t) { return true; };
  script += block(
      "reference", reference, [&](std::size_t i) { return reference.trace.force[i] / unit.in_SI; },
      everywhere);
  for (std::size_t k = 0; k < traces.size(); ++k) {
    const auto& t = traces[k];
    const auto F = [&](std::size_t i) { return t.force[i] / unit.in_SI; };
    const auto of_force = [&](std::size_t i) { return t.force[i] / reference.trace.force[i]; };
    const auto of_radius = [&](std::size_t i) { return t.radius[i] / reference.trace.radius[i]; };
    const auto of_pressure = [&](std::size_t i) { return of_force(i) / (of_radius(i) * of_radius(i)); };
    const auto both = [&](const char* name, const auto& value) {
      script += block(fmt::format("{}{}", name, k), reference, value,
                      [&](std::size_t i) { return static_cast<bool>(t.in_range[i]); }) +
                block(fmt::format("{}out{}", name, k), reference, value,
                      [&](std::size_t i) { return !t.in_range[i]; });
    };
    both("F", F);
    both("force", of_force);
    both("radius", of_radius);
    both("pressure", of_pressure);
  }
  script += fmt::format(
      "set border 3 lc rgb '{0}'\nset tics nomirror out scale 0.5 tc rgb '{0}'\nset grid lc rgb '#e3e7eb' lt "
      "1 lw 1\n"
      "unset key\n"
      "set multiplot\nset lmargin at screen 0.095\nset rmargin at screen 0.68\n"
      "set tmargin at screen 0.93\nset bmargin at screen 0.46\nset title {1} noenhanced tc rgb '{0}'\n"
      "set xrange [0:{2}]\nset yrange [0:{3}]\nset xtics {4}\nset xlabel 'overlap  δ/R' offset 0,0.5 tc rgb "
      "'{0}'\n"
      "set ylabel 'force F ({5})' tc rgb '{0}'\n",
      ink, gnuplot_string(title), x_max * 1.02, 1.5 * F_max / unit.in_SI, tick(x_max, 8), unit.name);
  const auto width = [&](std::size_t k) { return k < colours.size() ? 1.8 : 3; };
  const auto lines = [&](const char* name) {
    std::string text;
    for (std::size_t k = 0; k < traces.size(); ++k)
      text += fmt::format(
          ", ${0}{1} with lines lw {2} lc rgb '{4}', ${0}out{1} with lines lw {3} dt (5,4) lc rgb '{4}'",
          name, k, width(k), 0.7 * width(k), colours[k % colours.size()]);
    return text + "\n";
  };
  script += "plot $reference with lines lw 4 lc rgb 'black'" + lines("F");
  script +=
      fmt::format("unset title\nset tmargin at screen 0.36\nset bmargin at screen 0.085\n"
                  "set logscale x\nset xrange [{}:{}]\nset xtics auto\nset format x '10^{{%L}}'\n"
                  "set yrange [0:2]\nset ytics 0.5\nset xlabel 'overlap  δ/R' tc rgb '{}'\n",
                  std::max(1e-3 * x_max, reference.delta.front() / reference.radius_m), x_max * 1.02, ink);
  const std::array<std::array<const char*, 2>, 3> ratios = {{{"force", "force  F / F_{reference}"},
                                                             {"radius", "radius  a / a_{reference}"},
                                                             {"pressure", "pressure  p / p_{reference}"}}};
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    const double left = 0.095 + 0.32 * static_cast<double>(i);
    script += fmt::format("set lmargin at screen {}\nset rmargin at screen {}\nset ylabel '{}' tc rgb '{}'\n"
                          "plot 1 with lines lw 2.5 lc rgb 'black'{}",
                          left, left + 0.225, ratios[i][1], ink, lines(ratios[i][0]));
  }
  // The key is a plot of its own: beside the upper one it would have room for seven names. What does not fit
  // into one column gnuplot puts into a second one, outside of the picture.
  const double spacing = std::min(1.25, 17 / static_cast<double>(traces.size() + 2));
  script +=
      fmt::format("unset logscale\nunset border\nunset tics\nunset xlabel\nunset ylabel\nset xrange [0:1]\n"
                  "set yrange [0:1]\nset lmargin at screen 0.69\nset rmargin at screen 1\n"
                  "set tmargin at screen 0.95\nset bmargin at screen 0.42\nset key left top Left reverse "
                  "noenhanced samplen 2 spacing {:.3f} tc rgb '{}'\n"
                  "plot NaN with lines lw 4 lc rgb 'black' title {}",
                  spacing, ink, gnuplot_string(reference.trace.name));
  for (std::size_t k = 0; k < traces.size(); ++k)
    script += fmt::format(", NaN with lines lw {} lc rgb '{}' title {}", width(k),
                          colours[k % colours.size()], gnuplot_string(traces[k].name));
  script += ", NaN with lines lw 1.3 dt (5,4) lc rgb '#666666' title 'dashed: outside its validity'\nunset "
            "multiplot\n";
  run_gnuplot(script, file);
}

void compare_picture(const fit::Question& q, const fit::Comparison& c, const std::string& title,
                     const std::filesystem::path& file) {
  const press::Curve& curve = q.reference.curve;
  fit::Reference named = c.reference;
  if (!curve.experiment.empty()) named.trace.name = "press";
  const auto& its_own = curve.material.empty() ? q.reference.label : curve.material;
  compare_picture(named, c.traces, title.empty() ? its_own : title, file);
}

} // namespace platen::plot
