#include "plot/yield_picture.hpp"

#include "plot/axes.hpp"
#include "plot/gnuplot.hpp"
#include "plot/zone_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace platen::plot {
namespace {

/// From the earliest surface to the last: one hue, ever darker.
constexpr std::array<const char*, 5> shades = {"#b9c6d3", "#93a9bf", "#6d8ba9", "#476d92", "#1f4e79"};
constexpr const char* grid = "#e3e7eb";

struct Extent {
  double low = 0, high = 0, top = 0;
  void take(const std::vector<std::array<double, 2>>& p_q) {
    for (const auto& [p, q] : p_q) {
      low = std::min(low, -p);
      high = std::max(high, -p);
      top = std::max(top, q);
    }
  }
};

std::string block(const std::string& name, const std::vector<std::array<double, 2>>& p_q, double unit) {
  std::string text = fmt::format("${} << EOD\n", name);
  for (const auto& [p, q] : p_q) text += fmt::format("{:.8g} {:.8g}\n", -p / unit, q / unit);
  return text + "EOD\n";
}

} // namespace

void yield_picture(const std::vector<NamedCurve>& curves, const StressPath& path, const std::string& title,
                   const std::filesystem::path& file) {
  Extent extent;
  for (const auto& curve : curves) extent.take(curve.p_q);
  extent.take(path.p_q);
  const double largest = std::max({extent.high, -extent.low, extent.top, 1e-300});
  const Unit unit = unit_for(largest, {{"GPa", 1e9}, {"MPa", 1e6}, {"kPa", 1e3}, {"Pa", 1}});
  const double width = (extent.high - extent.low) / unit.in_SI, top = extent.top / unit.in_SI;

  std::string script = terminal(file, 800, 540), plot;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const std::size_t shade = curves.size() < 2 ? 4 : (4 * i) / (curves.size() - 1);
    script += block(fmt::format("yield{}", i), curves[i].p_q, unit.in_SI);
    plot += fmt::format("$yield{} with lines lw 2 lc rgb '{}' title {}, ", i, shades[shade],
                        gnuplot_string(curves[i].name));
  }
  script += block("path", path.p_q, unit.in_SI);
  plot += "$path with lines lw 1.2 lc rgb '#444444' title 'path'";
  for (int zone = 0; zone < 4; ++zone) {
    StressPath part;
    for (std::size_t i = 0; i < path.p_q.size(); ++i)
      if (static_cast<int>(path.zones[i]) == zone) part.p_q.push_back(path.p_q[i]);
    if (part.p_q.empty()) continue;
    script += block(fmt::format("zone{}", zone), part.p_q, unit.in_SI);
    plot += fmt::format(", $zone{} with points pt 7 ps 0.45 lc rgb '{}' title '{}'", zone,
                        zone_colour(static_cast<material::Zone>(zone)),
                        zone_name(static_cast<material::Zone>(zone)));
  }
  script += fmt::format(
      "set border 3 lc rgb '{0}' lw 1\nset tics nomirror out scale 0.5 tc rgb '{0}'\n"
      "set grid xtics ytics lc rgb '{1}' lt 1 lw 1\nset key outside right top Left reverse noenhanced "
      "samplen 1.5 "
      "spacing 1.25 tc rgb '{0}'\nset title {2} noenhanced tc rgb '{0}'\n"
      "set xrange [{3}:{4}]\nset yrange [0:{5}]\nset xtics {6}\nset ytics {7}\n"
      "set xlabel 'pressure  −p  ({8})' tc rgb '{0}'\nset ylabel 'shear stress  q  ({8})' tc rgb '{0}'\n",
      ink, grid, gnuplot_string(title), extent.low / unit.in_SI - 0.03 * width,
      extent.high / unit.in_SI + 0.03 * width, 1.06 * std::max(top, 1e-3 * width), tick(width, 8),
      tick(std::max(top, 1e-3 * width), 6), unit.name);
  run_gnuplot(script + "plot " + plot + "\n", file);
}

} // namespace platen::plot
