#include "plot/scene.hpp"

#include "core/file.hpp"
#include "plot/gnuplot.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <utility>

namespace platen::plot {

namespace fs = std::filesystem;

namespace {

using Buffer = std::back_insert_iterator<std::string>;

std::string escaped(const std::string& words) {
  std::string result;
  for (const char c : words) {
    if (c == '&') result += "&amp;";
    else if (c == '<') result += "&lt;";
    else if (c == '>') result += "&gt;";
    else if (c == '"') result += "&quot;";
    else result += c;
  }
  return result;
}

/// Tenths of a pixel as the shortest text.
std::string tenths(long value) {
  if (value % 10 == 0) return fmt::format("{}", value / 10);
  return fmt::format("{}{}.{}", value < 0 ? "-" : "",
                     std::abs(value) / 10 ? fmt::format("{}", std::abs(value) / 10) : "",
                     std::abs(value) % 10);
}

/// Path data in relative moves of whole tenths of a pixel: short, and free of accumulated rounding.
std::string path_data(const std::vector<Point>& points, bool closed) {
  std::string d;
  long x = 0, y = 0;
  bool moving = false;
  for (const Point& point : points) {
    const long next_x = std::lround(10 * point.x), next_y = std::lround(10 * point.y);
    if (!d.empty() && next_x == x && next_y == y) continue;
    const std::string dx = tenths(next_x - x), dy = tenths(next_y - y);
    if (d.empty()) d += 'M';
    else if (!std::exchange(moving, true)) d += 'l';
    else if (dx[0] != '-') d += ' ';
    d += dx;
    if (dy[0] != '-') d += ' ';
    d += dy;
    x = next_x;
    y = next_y;
  }
  if (closed) d += 'z';
  return d;
}

struct SvgItem {
  Buffer out;

  void operator()(const Polygon& polygon) const {
    // the thin outline of the same colour closes the seams that anti-aliasing leaves between neighbours
    fmt::format_to(out, "<path d=\"{}\" fill=\"{}\" stroke=\"{}\" stroke-width=\".8\"/>\n",
                   path_data(polygon.ring, true), polygon.fill, polygon.fill);
  }
  void operator()(const Line& line) const {
    fmt::format_to(
        out,
        "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:g}\" stroke-linecap=\"round\" "
        "stroke-linejoin=\"round\"/>\n",
        path_data(line.points, false), line.stroke, line.width);
  }
  void operator()(const Text& text) const {
    const char* anchors[] = {"start", "middle", "end"};
    fmt::format_to(
        out,
        "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{:g}\" text-anchor=\"{}\" fill=\"{}\"{}>{}</text>\n",
        text.at.x, text.at.y, text.size, anchors[static_cast<int>(text.anchor)], text.fill,
        text.bold ? " font-weight=\"600\"" : "", escaped(text.words));
  }
};

std::string svg(const Scene& scene) {
  std::string result;
  Buffer out(result);
  fmt::format_to(
      out,
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
      "{1:.0f}\" font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\" role=\"img\">\n"
      "<desc>{2}</desc>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
      scene.width, scene.height, escaped(scene.description));
  for (const auto& item : scene.items) std::visit(SvgItem{out}, item);
  result += "</svg>\n";
  return result;
}

struct GnuplotItem {
  Buffer out;
  double height;

  void ring(const std::vector<Point>& points) const {
    for (const Point& p : points) fmt::format_to(out, "{:.2f} {:.2f}\n", p.x, height - p.y);
    fmt::format_to(out, "e\n");
  }
  void operator()(const Polygon& polygon) const { ring(polygon.ring); }
  void operator()(const Line& line) const { ring(line.points); }
  void operator()(const Text&) const {}
};

/// Labels come first, then one plot element an item, then the inline data in the same order.
std::string gnuplot_script(const Scene& scene, const fs::path& file) {
  std::string result = terminal(file, static_cast<int>(scene.width), static_cast<int>(scene.height), 14);
  Buffer out(result);
  fmt::format_to(
      out,
      "unset key\nunset border\nunset tics\nset lmargin 0\nset rmargin 0\nset tmargin 0\nset bmargin 0\n"
      "set xrange [0:{}]\nset yrange [0:{}]\nset style fill solid 1 noborder\n",
      scene.width, scene.height);
  std::string elements, data;
  for (const auto& item : scene.items) {
    if (const auto* text = std::get_if<Text>(&item)) {
      const char* anchors[] = {"left", "center", "right"};
      fmt::format_to(out, "set label {} at {:.2f},{:.2f} {} font '{},{:g}' tc rgb '{}' noenhanced front\n",
                     gnuplot_string(text->words), text->at.x, scene.height - text->at.y + 0.33 * text->size,
                     anchors[static_cast<int>(text->anchor)], text->bold ? "sans:Bold" : "sans",
                     0.74 * text->size, text->fill);
      continue;
    }
    if (!elements.empty()) elements += ", \\\n ";
    if (const auto* polygon = std::get_if<Polygon>(&item))
      elements += fmt::format("'-' with filledcurves closed fc rgb '{}'", polygon->fill);
    if (const auto* line = std::get_if<Line>(&item))
      elements += fmt::format("'-' with lines lw {:g} lc rgb '{}'", 0.75 * line->width, line->stroke);
    std::visit(GnuplotItem{Buffer(data), scene.height}, item);
  }
  return result + "plot " + elements + '\n' + data;
}

} // namespace

void write(const Scene& scene, const fs::path& file) {
  if (format_of(file) == Format::png) return run_gnuplot(gnuplot_script(scene, file), file);
  core::write_file(file, svg(scene));
}

} // namespace platen::plot
