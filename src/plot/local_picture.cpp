#include "plot/local_picture.hpp"

#include "core/error.hpp"
#include "plot/axes.hpp"
#include "plot/gnuplot.hpp"
#include "plot/regions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace platen::plot {
namespace {

// Okabe and Ito's colours
constexpr std::array<const char*, 6> colours = {"#0072b2", "#d55e00", "#009e73",
                                                "#cc79a7", "#e69f00", "#56b4e9"};
constexpr const char* hertz_colour = "#5b6670";
/// Of plastic strain below the first of press::joining_strains, then of each band; lighter is less.
constexpr std::array<const char*, 6> bands = {"#e4ebf1", "#fee391", "#fdae61",
                                              "#ef6548", "#b3305c", "#4d1a5b"};

const std::vector<Unit> lengths = {{"mm", 1e-3}, {"µm", 1e-6}, {"nm", 1e-9}};
const std::vector<Unit> forces = {{"MN", 1e6},  {"kN", 1e3},  {"N", 1},
                                  {"mN", 1e-3}, {"µN", 1e-6}, {"nN", 1e-9}};
const std::vector<Unit> stresses = {{"GPa", 1e9}, {"MPa", 1e6}, {"kPa", 1e3}, {"Pa", 1}};

struct Hertz {
  double E_star, R;
  double radius(double F) const { return std::cbrt(3 * F * R / (4 * E_star)); }
  double approach(double F) const { return radius(F) * radius(F) / R; }
  double peak_pressure(double F) const { return 1.5 * F / (std::numbers::pi * radius(F) * radius(F)); }
};

Hertz hertz(const press::Curve& c) { return {c.E_Pa / (1 - c.nu * c.nu), c.radius_m}; }

/// Largest von Mises stress of Hertz's field, over p0: on the axis |sigma_z - sigma_r| (Johnson 3.45).
double hertz_mises(double nu) {
  double most = 0;
  for (double u = 0; u < 2; u += 1e-3) {
    const double angle = u > 0 ? std::atan(1 / u) : std::numbers::pi / 2;
    most = std::max(most, std::abs(1.5 / (1 + u * u) - (1 + nu) * (1 - u * angle)));
  }
  return most;
}

std::string begin(const press::Curve& curve, const std::filesystem::path& file, int width, int height) {
  return terminal(file, width, height) +
         fmt::format("set border 3 lc rgb '{0}' lw 1\nset tics nomirror out scale 0.5 tc rgb '{0}'\n"
                     "set grid xtics ytics lc rgb '#e3e7eb' lt 1 lw 1\n"
                     "set key left top Left reverse noenhanced samplen 2.2 spacing 1.25 tc rgb '{0}'\n"
                     "set title {1} noenhanced tc rgb '{0}'\n",
                     ink,
                     gnuplot_string(fmt::format("{}, R₀ = {:.4g} mm", curve.material, curve.radius_m * 1e3)));
}

std::string labels(const std::string& x, const std::string& y) {
  return fmt::format("set xlabel {} tc rgb '{}'\nset ylabel {} tc rgb '{}'\n", gnuplot_string(x), ink,
                     gnuplot_string(y), ink);
}

const press::CurvePoint& end_of(const press::Result& result) {
  const auto* end = press::loading_end(result.curve);
  if (!end || !(end->force_N > 0)) throw core::InvalidInput("the curve to draw has no point with a force");
  return *end;
}

void need_profiles(const press::Result& result) {
  if (result.profiles.empty()) throw core::InvalidInput("no load was asked for, so there is nothing to draw");
}

} // namespace

void approach_picture(const press::Result& result, const std::filesystem::path& file) {
  const press::Curve& curve = result.curve;
  const press::CurvePoint& end = end_of(result);
  const Hertz law = hertz(curve);
  const Unit length = unit_for(end.hertz_delta_m, lengths), force = unit_for(end.force_N, forces);
  const auto line = [&](double delta, double F) {
    return fmt::format("{:.8g} {:.8g}\n", delta / length.in_SI, F / force.in_SI);
  };
  std::string loading, others, elastic, yield;
  int branch = 0;
  for (const auto& p : curve.points) {
    const bool loads = p.branch == press::Branch::loading;
    if (!loads && p.branch_id != branch) {
      if (branch > 0) others += '\n'; // lifts the pen
      ++branch;
    }
    (loads ? loading : others) += line(p.hertz_delta_m, p.force_N);
  }
  for (int i = 0; i <= 200; ++i) {
    const double F = end.force_N * std::pow(i / 200.0, 1.5);
    elastic += line(law.approach(F), F);
  }
  if (result.axis) yield = line(law.approach(result.axis->force_N), result.axis->force_N);
  std::string script =
      begin(curve, file, 800, 540) +
      labels(fmt::format("approach of the centre to the plane δ, far field taken out ({})", length.name),
             fmt::format("force F ({})", force.name)) +
      "$loading << EOD\n" + loading + "EOD\n$others << EOD\n" + others + "EOD\n$hertz << EOD\n" + elastic +
      "EOD\n$yield << EOD\n" + yield + "EOD\nset xrange [0:*]\nset yrange [0:*]\nplot ";
  script += fmt::format("$hertz with lines lw 1.4 dt (8,4) lc rgb '{}' title 'Hertz', ", hertz_colour);
  if (!others.empty()) script += "$others with lines lw 1.4 lc rgb '#9aa8b5' title 'unloading', ";
  script += fmt::format("$loading with lines lw 2.4 lc rgb '{}' title 'press'", colours[0]);
  if (!yield.empty())
    script += fmt::format(", $yield with points pt 7 ps 0.7 lc rgb '{}' title 'first yield on the axis'",
                          colours[1]);
  run_gnuplot(script + "\n", file);
}

void peaks_picture(const press::Result& result, const std::filesystem::path& file) {
  const press::Curve& curve = result.curve;
  const press::CurvePoint& end = end_of(result);
  const Hertz law = hertz(curve);
  const double mises = hertz_mises(curve.nu), top = law.peak_pressure(end.force_N);
  const Unit force = unit_for(end.force_N, forces), stress = unit_for(top, stresses);
  std::string press, elastic;
  for (const auto& p : curve.points)
    if (p.branch == press::Branch::loading && p.force_N > 0)
      press += fmt::format("{:.8g} {:.8g} {:.8g}\n", p.force_N / force.in_SI,
                           p.peak_pressure_Pa / stress.in_SI, p.mises_max_Pa / stress.in_SI);
  for (int i = 0; i <= 200; ++i) {
    const double F = end.force_N * std::pow(std::max(i / 200.0, 1e-6), 3), p0 = law.peak_pressure(F);
    elastic +=
        fmt::format("{:.8g} {:.8g} {:.8g}\n", F / force.in_SI, p0 / stress.in_SI, mises * p0 / stress.in_SI);
  }
  run_gnuplot(
      begin(curve, file, 800, 480) +
          labels(fmt::format("force F ({})", force.name), fmt::format("stress ({})", stress.name)) +
          "$press << EOD\n" + press + "EOD\n$hertz << EOD\n" + elastic +
          "EOD\nset xrange [0:*]\nset yrange [0:*]\nset key right bottom\n" +
          fmt::format(
              "plot $hertz using 1:2 with lines lw 1.2 dt (8,4) lc rgb '{0}' title 'Hertz, peak pressure',"
              " $hertz using 1:3 with lines lw 1.2 dt (8,4) lc rgb '{1}' title 'Hertz, von Mises',"
              " $press using 1:2 with lines lw 2.2 lc rgb '{0}' title 'peak contact pressure',"
              " $press using 1:3 with lines lw 2.2 lc rgb '{1}' title 'largest von Mises stress'\n",
              colours[0], colours[1]),
      file);
}

void pressure_picture(const press::Result& result, const std::filesystem::path& file) {
  need_profiles(result);
  const press::Curve& curve = result.curve;
  const Hertz law = hertz(curve);
  double r_max = 0, p_max = 0;
  for (const auto& p : result.profiles) {
    r_max = std::max({r_max, p.contact_radius_m, law.radius(p.force_N)});
    p_max = std::max(p_max, law.peak_pressure(p.force_N));
  }
  const Unit length = unit_for(r_max, lengths), stress = unit_for(p_max, stresses);
  std::string script =
      begin(curve, file, 800, 480) +
      labels(fmt::format("distance from the axis ({})", length.name),
             fmt::format("contact pressure ({})", stress.name)) +
      fmt::format("set xrange [0:{}]\nset yrange [0:*]\nset key right top\n", 1.15 * r_max / length.in_SI);
  std::string plots;
  for (std::size_t i = 0; i < result.profiles.size(); ++i) {
    const auto& p = result.profiles[i];
    script += fmt::format("$press{} << EOD\n", i);
    for (const auto& [r, pressure] : p.points)
      script += fmt::format("{:.8g} {:.8g}\n", r / length.in_SI, pressure / stress.in_SI);
    script += fmt::format("EOD\n$hertz{} << EOD\n", i);
    const double a = law.radius(p.force_N);
    for (int k = 0; k <= 100; ++k) { // close together at the edge, where it falls steeply
      const double angle = std::numbers::pi / 2 * k / 100;
      script += fmt::format("{:.8g} {:.8g}\n", a * std::sin(angle) / length.in_SI,
                            law.peak_pressure(p.force_N) * std::cos(angle) / stress.in_SI);
    }
    script += "EOD\n";
    const char* colour = colours[i % colours.size()];
    const Unit force = unit_for(p.force_N, forces);
    plots +=
        fmt::format("$hertz{0} with lines lw 1.2 dt (8,4) lc rgb '{1}' notitle, $press{0} with lines lw 2.2 "
                    "lc rgb '{1}' title '{2:.4g} {3}', ",
                    i, colour, p.force_N / force.in_SI, force.name);
  }
  run_gnuplot(script + "plot " + plots +
                  fmt::format("1/0 with lines lw 1.2 dt (8,4) lc rgb '{}' title 'Hertz'\n", hertz_colour),
              file);
}

namespace {

/// Half of the section near the contact: a ring of vertices (r, depth below the plane, in contact radii) for
/// each patch of one band.
std::vector<Region> plastic_bands(const press::Snapshot& s, double a_bar, double reach) {
  Patchwork patches;
  for (const auto& [r, z] : s.nodes) patches.vertices.push_back({r / a_bar, (1 - s.delta_bar - z) / a_bar});
  for (std::size_t e = 0; e < s.elements.size(); ++e) {
    const auto near = [&](int node) {
      const Point& p = patches.vertices[static_cast<std::size_t>(node)];
      return p.x < reach && p.y < reach;
    };
    if (std::ranges::none_of(s.elements[e], near)) continue;
    const double v = s.plastic_strain_v[e], q = s.plastic_strain_q[e];
    const double strain = std::sqrt(q * q + 2.0 / 9 * v * v);
    const auto& steps = press::joining_strains;
    const auto band = std::upper_bound(steps.begin(), steps.end(), strain) - steps.begin();
    std::array<int, 4> corners = s.elements[e];
    std::swap(corners[1], corners[3]); // depth turned the sense of rotation
    patches.cells.push_back({corners, static_cast<int>(band)});
  }
  return regions(patches);
}

/// A panel of its own below the others.
std::string band_key(int height, int key_height) {
  std::string script = fmt::format(
      "set size noratio\nset lmargin at screen 0\nset rmargin at screen 1\nset bmargin at screen 0\n"
      "set tmargin at screen {}\nunset border\nunset tics\nunset xlabel\nunset ylabel\nunset title\n"
      "set key center center horizontal Left reverse noenhanced samplen 1 width 1 maxrows 1 font ',12'\n"
      "set yrange [0:1]\nplot 2 with points pt 5 ps 0.1 lc rgb 'white' title 'plastic strain'",
      static_cast<double>(key_height) / height);
  const auto& steps = press::joining_strains;
  for (std::size_t i = 0; i < bands.size(); ++i)
    script += fmt::format(", 2 with points pt 5 ps 1.6 lc rgb '{}' title '{}{}'", bands[i],
                          i ? "from " : "less", i ? fmt::format("{:g}", steps[i - 1]) : "");
  return script + "\n";
}

} // namespace

void plastic_zone_picture(const press::Result& result, const std::filesystem::path& file) {
  need_profiles(result);
  const press::Curve& curve = result.curve;
  const int panels = static_cast<int>(std::min(result.profiles.size(), result.snapshots.size()));
  constexpr double width = 2.4, depth = 2.4; // shown, in contact radii
  constexpr int least_width = 640, panel_width = 400, panel_height = 440, key_height = 64;
  const int columns = std::min(panels, 3), rows = (panels + columns - 1) / columns;
  const int height = rows * panel_height + key_height;
  std::string script = begin(curve, file, std::max(columns * panel_width, least_width), height) +
                       fmt::format("set multiplot\nunset key\nunset grid\nset size ratio -1\n"
                                   "set xrange [0:{}]\nset yrange [{}:-0.15]\n",
                                   width, depth);
  for (int i = 0; i < panels; ++i) {
    const auto& p = result.profiles[i];
    const Unit force = unit_for(p.force_N, forces), length = unit_for(p.contact_radius_m, lengths);
    const int column = i % columns, row = i / columns;
    script += fmt::format(
        "set lmargin at screen {}\nset rmargin at screen {}\nset tmargin at screen {}\nset bmargin "
        "at screen {}\n",
        (column + 0.19) / columns, (column + 0.97) / columns, 1 - (row * panel_height + 45.0) / height,
        1 - (row * panel_height + 375.0) / height);
    script += labels("r/a", "depth/a") + "set ylabel offset 1.5,0\n";
    script +=
        fmt::format("set title {} noenhanced tc rgb '{}'\n",
                    gnuplot_string(fmt::format("{:.4g} {}, a = {:.3g} {}", p.force_N / force.in_SI,
                                               force.name, p.contact_radius_m / length.in_SI, length.name)),
                    ink);
    std::string plots;
    int n = 0;
    for (const Region& region :
         plastic_bands(result.snapshots[i], p.contact_radius_m / curve.radius_m, 1.3 * width)) {
      script += fmt::format("$patch{} << EOD\n", n);
      for (const Point& x : region.ring) script += fmt::format("{:.4f} {:.4f}\n", x.x, x.y);
      script += "EOD\n";
      plots += fmt::format("{}$patch{} with filledcurves closed fc rgb '{}' notitle", n ? ", " : "", n,
                           bands[region.colour]);
      ++n;
    }
    script += fmt::format("plot {}\n", plots);
  }
  run_gnuplot(script + band_key(height, key_height) + "unset multiplot\n", file);
}

} // namespace platen::plot
