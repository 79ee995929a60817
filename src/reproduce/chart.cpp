#include "reproduce/chart.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/number.hpp"
#include "plot/axes.hpp"
#include "plot/gnuplot.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace platen::reproduce {
namespace {

// Okabe and Ito's colours (jfly.uni-koeln.de/color), told apart by every kind of colour vision
constexpr std::array colours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                "#e69f00", "#56b4e9", "#7f6a3f", "#444444"};

bool drawable(const Chart& chart, double x, double y) {
  return std::isfinite(x) && std::isfinite(y) && (!chart.log_x || x > 0) && (!chart.log_y || y > 0);
}

std::string style(const Series& s, std::size_t place) {
  const std::string colour = s.colour.empty() ? colours[place % colours.size()] : s.colour;
  switch (s.mark) {
  case Mark::line:
    return fmt::format("with lines lw 2.2 lc rgb '{}'", colour);
  case Mark::dashed:
    return fmt::format("with lines lw 2 dt (7,4) lc rgb '{}'", colour);
  case Mark::points:
    break;
  }
  return fmt::format("with points pt 7 ps 0.6 lc rgb '{}'", colour);
}

} // namespace

std::string csv_text(const Chart& chart) {
  std::string text = fmt::format("# title = {}\n# x = {}\n# y = {}\nseries,x,y\n", chart.title, chart.x_label,
                                 chart.y_label);
  for (const Series& s : chart.series) {
    std::string name = s.name; // a comma would be another cell
    for (char& c : name)
      if (c == ',') c = ';';
    for (std::size_t i = 0; i < s.x.size(); ++i)
      if (std::isfinite(s.x[i]) && std::isfinite(s.y[i]))
        fmt::format_to(std::back_inserter(text), "{},{:.6g},{:.6g}\n", name, s.x[i], s.y[i]);
  }
  return text;
}

void draw(const Chart& chart, const std::filesystem::path& file) {
  std::filesystem::path svg = file, csv = file;
  svg += ".svg";
  csv += ".csv";
  std::string script = plot::terminal(svg, chart_width, chart_height, 12), plots;
  for (std::size_t k = 0; k < chart.series.size(); ++k) {
    const Series& s = chart.series[k];
    std::string points;
    for (std::size_t i = 0; i < s.x.size(); ++i)
      if (drawable(chart, s.x[i], s.y[i]))
        fmt::format_to(std::back_inserter(points), "{:.7g} {:.7g}\n", s.x[i], s.y[i]);
    if (points.empty()) continue;
    script += fmt::format("$s{} << EOD\n{}EOD\n", k, points);
    plots += fmt::format("{}$s{} {} title {}", plots.empty() ? "" : ", ", k, style(s, k),
                         plot::gnuplot_string(s.name));
  }
  if (plots.empty())
    throw core::InvalidInput(fmt::format("{}: the chart '{}' has no point", file.string(), chart.title));
  script += fmt::format(
      "set border 3 lc rgb '{0}'\nset tics nomirror out scale 0.5 tc rgb '{0}'\n"
      "set grid lc rgb '#e3e7eb' lt 1 lw 1\n"
      "set key outside below center horizontal noenhanced samplen 2 spacing 1.1 maxrows 4 tc rgb '{0}'\n"
      "set title {1} noenhanced tc rgb '{0}'\nset xlabel {2} noenhanced tc rgb '{0}'\n"
      "set ylabel {3} noenhanced tc rgb '{0}'\n",
      plot::ink, plot::gnuplot_string(chart.title), plot::gnuplot_string(chart.x_label),
      plot::gnuplot_string(chart.y_label));
  script += "set format x '%g'\nset format y '%g'\n";
  if (chart.equal_scales) script += "set size ratio -1\n";
  if (chart.log_x) script += "set logscale x\n";
  if (chart.log_y) script += "set logscale y\n";
  if (chart.y_range) script += fmt::format("set yrange [{}:{}]\n", (*chart.y_range)[0], (*chart.y_range)[1]);
  plot::run_gnuplot(script + "plot " + plots + "\n", svg);
  core::write_file(csv, csv_text(chart));
}

} // namespace platen::reproduce
