#include "plot/curve_picture.hpp"

#include "core/error.hpp"
#include "fit/samples.hpp"
#include "plot/axes.hpp"
#include "plot/gnuplot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace platen::plot {

namespace {

// Okabe and Ito's colours (jfly.uni-koeln.de/color), told apart by every kind of colour vision
constexpr const char* press_colour = "#0072b2";
constexpr const char* law_colour = "#d55e00";
constexpr const char* unloading_colour = "#9aa8b5";
constexpr const char* grid = "#e3e7eb";

using Points = std::vector<std::pair<double, double>>;

std::string data_block(const std::string& name, const Points& points) {
  std::string result = fmt::format("${} << EOD\n", name);
  for (const auto& [x, y] : points) result += fmt::format("{:.8g} {:.8g}\n", x, y);
  return result + "EOD\n";
}

Points loading(const press::Curve& curve) {
  Points result;
  for (const auto& point : curve.points)
    if (point.branch == press::Branch::loading) result.emplace_back(point.delta_bar, point.F_bar);
  return result;
}

/// Unloading and reloading branches, each a block of its own: an empty line lifts the pen.
std::string other_branches(const press::Curve& curve) {
  std::string result;
  int last = 0;
  for (const auto& point : curve.points) {
    if (point.branch == press::Branch::loading) continue;
    if (point.branch_id != last && !result.empty()) result += '\n';
    last = point.branch_id;
    result += fmt::format("{:.8g} {:.8g}\n", point.delta_bar, point.F_bar);
  }
  return result;
}

/// The unloading law of each branch from separation to the turning point.
std::string unloading_block(const std::vector<fit::UnloadingFit>& unloading) {
  constexpr int steps = 40;
  std::string result = "$unloading << EOD\n";
  for (const auto& fit : unloading) {
    for (int i = 0; i <= steps; ++i) {
      const double x = fit.delta_bar_0 + (fit.delta_bar_max - fit.delta_bar_0) * i / steps;
      result += fmt::format("{:.8g} {:.8g}\n", x, fit.F_bar(x));
    }
    result += '\n';
  }
  return result + "EOD\n";
}

double interpolated(const std::vector<double>& x, const std::vector<double>& y, double at) {
  const auto above = std::upper_bound(x.begin() + 1, x.end() - 1, at) - x.begin();
  const auto i = static_cast<std::size_t>(above);
  return y[i - 1] + (y[i] - y[i - 1]) * (at - x[i - 1]) / (x[i] - x[i - 1]);
}

/// Residuals in per cent of the largest force, where the law is drawn.
Points residuals(const Points& points, const std::vector<double>& delta_bar,
                 const std::vector<double>& F_bar_law, double F_bar_max) {
  Points result;
  for (const auto& [x, y] : points)
    if (x >= delta_bar.front() * (1 - 1e-12) && x <= delta_bar.back() * (1 + 1e-12))
      result.emplace_back(x, 100 * (interpolated(delta_bar, F_bar_law, x) - y) / F_bar_max);
  return result;
}

/// ": relative L2 2.5 %, peak 2.7 %" when the law is drawn along the whole loading branch.
std::string errors_text(const Points& points, const std::vector<double>& delta_bar,
                        const std::vector<double>& F_bar_law, std::size_t residuals) {
  if (points.size() < 2 || residuals != points.size()) return "";
  fit::Samples samples;
  std::vector<double> law;
  for (const auto& [x, y] : points) {
    samples.delta_bar.push_back(x);
    samples.F_bar.push_back(y);
    law.push_back(interpolated(delta_bar, F_bar_law, x));
  }
  samples.weight = fit::trapezoid_weights(samples.delta_bar, 0);
  const fit::Errors errors = fit::errors(samples, law);
  return fmt::format(": relative L2 {:.2g} %, peak {:.2g} %", 100 * errors.relative_l2, 100 * errors.e_p);
}

std::string title(const press::Curve& curve) {
  std::string result = curve.material.empty() ? "curve" : curve.material;
  if (!curve.experiment.empty()) result += fmt::format(", {} compression", curve.experiment);
  if (curve.radius_m > 0) {
    const Unit unit = unit_for(curve.radius_m, {{"mm", 1e-3}, {"µm", 1e-6}, {"nm", 1e-9}});
    result += fmt::format(", R₀ = {:.4g} {}", curve.radius_m / unit.in_SI, unit.name);
  }
  return result;
}

std::string style() {
  return fmt::format("set border 3 lc rgb '{0}' lw 1\nset tics nomirror out scale 0.5 tc rgb '{0}'\n"
                     "set grid xtics ytics lc rgb '{1}' lt 1 lw 1\n"
                     "set key left top Left reverse noenhanced samplen 2.2 spacing 1.25 tc rgb '{0}'\n",
                     ink, grid);
}

struct Ranges {
  double x_max, y_max;
};

Ranges ranges(const press::Curve& curve, const std::vector<double>& F_bar_law) {
  Ranges result{0, 0};
  for (const auto& point : curve.points) {
    if (!std::isfinite(point.delta_bar) || !std::isfinite(point.F_bar))
      throw core::InvalidInput("the curve to draw has a point that is not finite");
    result.x_max = std::max(result.x_max, point.delta_bar);
    result.y_max = std::max(result.y_max, point.F_bar);
  }
  for (const double value : F_bar_law)
    if (std::isfinite(value)) result.y_max = std::max(result.y_max, value);
  if (!(result.x_max > 0) || !(result.y_max > 0))
    throw core::InvalidInput("the curve to draw has no point with positive overlap and force");
  return result;
}

/// Upper panel: blocks $press, $law, $other are defined before.
std::string upper_panel(const press::Curve& curve, Ranges range, const std::string& law_name, bool has_other,
                        bool has_unloading_law) {
  const double y_top = range.y_max * 1.06, x_top = range.x_max * 1.02;
  std::string script =
      fmt::format("set title {} offset 0,0.2 noenhanced tc rgb '{}'\nset xrange [0:{}]\nset yrange [0:{}]\n"
                  "set xtics {}\nset ytics {}\nset ylabel 'force  F̄ = F/(πR₀²σ_{{ref}})' tc rgb '{}'\n",
                  gnuplot_string(title(curve)), ink, x_top, y_top, tick(x_top, 8), tick(y_top, 8), ink);
  script += second_axes(curve, x_top, y_top);
  if (curve.radius_m > 0 && curve.sigma_ref_Pa > 0) script += "set border 11\n";
  script += "plot ";
  const bool reloads = std::ranges::any_of(
      curve.points, [](const auto& point) { return point.branch == press::Branch::reloading; });
  if (has_other)
    script += fmt::format("$other with lines lw {} lc rgb '{}' title 'unloading{}', ",
                          has_unloading_law ? 3 : 1.2, unloading_colour, reloads ? ", reloading" : "");
  script += fmt::format("$press with {} title 'press'",
                        law_name.empty() ? fmt::format("lines lw 2.4 lc rgb '{}'", press_colour)
                                         : fmt::format("lines lw 3.2 lc rgb '{}'", press_colour));
  if (!law_name.empty())
    script += fmt::format(", $law with lines lw 1.8 dt (8,4) lc rgb '{}' title {}", law_colour,
                          gnuplot_string(law_name));
  if (has_unloading_law)
    script +=
        fmt::format(", $unloading with lines lw 1.2 dt (6,4) lc rgb '{}' title 'law, unloading'", law_colour);
  return script + "\n";
}

std::string lower_panel(const Points& residual, double x_top) {
  double largest = 0;
  for (const auto& [x, y] : residual) largest = std::max(largest, std::abs(y));
  const double step = tick(std::max(largest, 1e-6) * 1.1, 2),
               top = step * std::ceil(largest * 1.1 / step - 1e-9);
  return fmt::format("unset title\nunset x2tics\nunset x2label\nunset y2tics\nunset y2label\nset "
                     "border 3\nunset key\n"
                     "set xrange [0:{}]\nset yrange [{}:{}]\nset ytics {}\n"
                     "set xlabel 'overlap  δ̄ = δ/R₀' tc rgb '{}'\nset ylabel '(F_{{law}} − "
                     "F)/F_{{max}}  (%)' tc rgb '{}'\n"
                     "plot 0 with lines lw 1 lc rgb '{}' notitle, "
                     "$residual with filledcurves y=0 fc rgb '{}' fs transparent solid 0.15 notitle, "
                     "$residual with lines lw 1.8 lc rgb '{}' notitle\n",
                     x_top, -std::max(top, 1e-6), std::max(top, 1e-6), step, ink, ink, ink, law_colour,
                     law_colour);
}

} // namespace

void curve_with_law(const press::Curve& curve, const std::vector<double>& delta_bar,
                    const std::vector<double>& F_bar_law, const std::string& law_name,
                    const std::filesystem::path& file, const std::vector<fit::UnloadingFit>& unloading) {
  if (delta_bar.size() != F_bar_law.size() || delta_bar.size() < 2)
    throw core::InvalidInput(
        fmt::format("a law is drawn through two points or more; it has {} overlaps and {} forces",
                    delta_bar.size(), F_bar_law.size()));
  if (std::adjacent_find(delta_bar.begin(), delta_bar.end(), [](double a, double b) { return !(a < b); }) !=
      delta_bar.end())
    throw core::InvalidInput("the overlaps at which a law is drawn do not ascend");
  const Ranges range = ranges(curve, F_bar_law);
  const Points press_points = loading(curve);
  double F_bar_max = 0;
  for (const auto& [x, y] : press_points) F_bar_max = std::max(F_bar_max, y);
  if (!(F_bar_max > 0)) F_bar_max = range.y_max;
  const Points residual = residuals(press_points, delta_bar, F_bar_law, F_bar_max);
  Points law;
  for (std::size_t i = 0; i < delta_bar.size(); ++i) law.emplace_back(delta_bar[i], F_bar_law[i]);

  const std::string other = other_branches(curve);
  std::string script = terminal(file, 800, 680) + data_block("press", press_points) + data_block("law", law) +
                       data_block("residual", residual) + unloading_block(unloading) + "$other << EOD\n" +
                       other + "EOD\n" + style();
  script += "set multiplot\nset lmargin at screen 0.105\nset rmargin at screen 0.895\n"
            "set tmargin at screen 0.85\nset bmargin at screen 0.335\nset format x ''\n";
  script +=
      upper_panel(curve, range, law_name + errors_text(press_points, delta_bar, F_bar_law, residual.size()),
                  !other.empty(), !unloading.empty());
  script += "set format x '%g'\nset tmargin at screen 0.295\nset bmargin at screen 0.095\n";
  script += lower_panel(residual, range.x_max * 1.02) + "unset multiplot\n";
  run_gnuplot(script, file);
}

void curve_picture(const press::Curve& curve, const std::filesystem::path& file) {
  const Ranges range = ranges(curve, {});
  const std::string other = other_branches(curve);
  std::string script = terminal(file, 800, 540) + data_block("press", loading(curve)) + "$other << EOD\n" +
                       other + "EOD\n" + style() +
                       fmt::format("set xlabel 'overlap  δ̄ = δ/R₀' tc rgb '{}'\n", ink);
  run_gnuplot(script + upper_panel(curve, range, "", !other.empty(), false), file);
}

} // namespace platen::plot
