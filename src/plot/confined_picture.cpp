#include "plot/confined_picture.hpp"

#include "core/error.hpp"
#include "plot/axes.hpp"
#include "plot/colour_scale.hpp"
#include "plot/gnuplot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace platen::plot {
namespace {

constexpr const char* names[] = {"x", "y", "z"}; ///< of the planes

using fe::Vector3, fe::operator+, fe::operator-, fe::operator*;
using press::SpatialSnapshot;

constexpr double panel = 300, margin = 24, title_height = 64;

Vector3 mapped(const std::array<Vector3, 3>& copy, const Vector3& x) {
  return {fe::dot(copy[0], x), fe::dot(copy[1], x), fe::dot(copy[2], x)};
}

/// A face that only one element has.
struct BoundaryFace {
  std::array<int, 4> nodes;
  int element;
};

std::vector<BoundaryFace> boundary(const SpatialSnapshot& s) {
  constexpr int sides[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                               {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  std::map<std::array<int, 4>, std::pair<int, BoundaryFace>> seen;
  for (int e = 0; e < static_cast<int>(s.elements.size()); ++e)
    for (const auto& side : sides) {
      std::array<int, 4> nodes;
      for (int k = 0; k < 4; ++k) nodes[k] = s.elements[e][side[k]];
      std::array<int, 4> key = nodes;
      std::sort(key.begin(), key.end());
      auto& [count, face] = seen[key];
      ++count;
      face = {nodes, e};
    }
  std::vector<BoundaryFace> faces;
  for (const auto& [key, value] : seen)
    if (value.first == 1) faces.push_back(value.second);
  return faces;
}

std::string shaded(const std::string& colour, double light) {
  std::array<int, 3> rgb{};
  for (int c = 0; c < 3; ++c)
    rgb[c] = static_cast<int>(std::lround(light * std::stoi(colour.substr(1 + 2 * c, 2), nullptr, 16)));
  return fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]);
}

// Seen from the side on which the octant x > 0, y < 0, z > 0 is taken out.
const Vector3 towards_eye = fe::unit(fe::Vector3{1, -1.25, 0.85});
const Vector3 to_the_right = fe::unit(fe::cross(Vector3{0, 0, 1}, towards_eye));
const Vector3 upwards = fe::cross(towards_eye, to_the_right);

void add_particle(Scene& scene, const SpatialSnapshot& s, const Range& range, Point middle, double pixels) {
  struct Piece {
    double depth;
    Polygon polygon;
  };
  const auto colours = viridis();
  const auto faces = boundary(s);
  std::vector<Vector3> undeformed;
  for (std::size_t n = 0; n < s.nodes.size(); ++n) undeformed.push_back(s.nodes[n] - s.displacement[n]);
  std::vector<Piece> pieces;
  for (const auto& copy : s.copies)
    for (const auto& [nodes, element] : faces) {
      Vector3 was{}, x[4], centre{};
      bool outside = true;
      for (int k = 0; k < 4; ++k) {
        was = was + 0.25 * mapped(copy, undeformed[nodes[k]]);
        x[k] = mapped(copy, s.nodes[nodes[k]]);
        centre = centre + 0.25 * x[k];
        outside = outside && std::abs(fe::norm(undeformed[nodes[k]]) - 1) < 1e-9;
      }
      constexpr double on_plane = 1e-9;
      if (outside) {
        if (was[0] > 0 && was[1] < 0 && was[2] > 0) continue;
      } else { // of the cut, the three sides of the octant
        const bool at_x = std::abs(was[0]) < on_plane && was[1] < -on_plane && was[2] > on_plane;
        const bool at_y = std::abs(was[1]) < on_plane && was[0] > on_plane && was[2] > on_plane;
        const bool at_z = std::abs(was[2]) < on_plane && was[0] > on_plane && was[1] < -on_plane;
        if (!at_x && !at_y && !at_z) continue;
      }
      Vector3 normal = fe::cross(x[2] - x[0], x[3] - x[1]);
      if (!(fe::norm(normal) > 0)) continue;
      normal = fe::unit(normal);
      const double faces_eye = fe::dot(normal, towards_eye);
      const bool outward = fe::dot(normal, centre) > 0;
      if (outside && (faces_eye > 0) != outward) continue; // the far side
      Piece& piece = pieces.emplace_back();
      piece.depth = fe::dot(centre, towards_eye);
      piece.polygon.fill = shaded(colours[static_cast<std::size_t>(range.level(s.plastic_strain_q[element]))],
                                  0.72 + 0.28 * std::abs(faces_eye));
      for (const auto& corner : x)
        piece.polygon.ring.push_back({middle.x + pixels * fe::dot(corner, to_the_right),
                                      middle.y - pixels * fe::dot(corner, upwards)});
    }
  std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.depth < b.depth; });
  for (auto& piece : pieces) scene.items.push_back(std::move(piece.polygon));
}

void check(const std::vector<SpatialSnapshot>& snapshots) {
  if (snapshots.empty()) throw core::InvalidInput("no moment was asked for, so there is nothing to draw");
}

Scene page(const std::string& title, double width, double height) {
  Scene scene;
  // The title and the words beside the colour bar have to fit, however few panels there are.
  scene.width = std::max({width, 520.0, 2 * margin + 10.5 * static_cast<double>(title.size())});
  scene.height = height;
  scene.items.push_back(Text{{margin, 30}, title, 17, Anchor::start, ink, true});
  return scene;
}

/// What the planes have moved; each by itself where they do not count time in one overlap.
std::string overlaps_text(const SpatialSnapshot& s) {
  if (s.plane[2] > 0 && std::abs(1 - s.plane[2] - s.delta_bar) < 1e-9)
    return fmt::format("δ/R₀ = {:.4g}", s.delta_bar);
  std::string text;
  for (const int axis : {2, 0, 1})
    if (s.plane[axis] > 0)
      text += fmt::format("{}δ{}/R₀ = {:.4g}", text.empty() ? "" : ", ", names[axis], 1 - s.plane[axis]);
  return text;
}

} // namespace

void particle_picture(const std::vector<SpatialSnapshot>& snapshots, const std::string& title,
                      const std::filesystem::path& file) {
  check(snapshots);
  double most = 0;
  for (const auto& s : snapshots)
    for (const double strain : s.plastic_strain_q) most = std::max(most, strain);
  const Range range = round_range(0, most);
  Scene scene = page(title, 2 * margin + panel * static_cast<double>(snapshots.size()),
                     title_height + panel + 70 + margin);
  scene.description = title + ": the particle with an octant taken out";
  for (std::size_t i = 0; i < snapshots.size(); ++i) {
    const double x = margin + panel * (static_cast<double>(i) + 0.5);
    scene.items.push_back(
        Text{{x, title_height - 4}, overlaps_text(snapshots[i]), 14, Anchor::middle, ink, false});
    add_particle(scene, snapshots[i], range, {x, title_height + panel / 2}, 0.43 * panel);
  }
  (void)colour_bar(scene, {margin, title_height + panel + 20}, "plastic Hencky strain √(2/3 e:e)", range);
  write(scene, file);
}

void faces_picture(const std::vector<SpatialSnapshot>& snapshots, double sigma_ref_Pa,
                   const std::string& title, const std::filesystem::path& file) {
  check(snapshots);
  std::vector<int> planes;
  double most = 0;
  for (const int axis : {2, 0, 1}) {
    bool touched = false;
    for (const auto& s : snapshots)
      for (const auto& p : s.pressure) {
        touched = touched || p[axis] > 0;
        most = std::max(most, p[axis] / sigma_ref_Pa);
      }
    if (touched) planes.push_back(axis);
  }
  if (planes.empty()) throw core::InvalidInput("no plane is touched, so there is nothing to draw");
  const Range range = round_range(0, most);
  const auto colours = viridis();
  constexpr double size = 220, gap = 62, left = 64;
  Scene scene = page(title, left + (size + gap) * static_cast<double>(snapshots.size()),
                     title_height + (size + gap) * static_cast<double>(planes.size()) + 50);
  scene.description = title + " over each plane";
  for (std::size_t row = 0; row < planes.size(); ++row)
    for (std::size_t column = 0; column < snapshots.size(); ++column) {
      const SpatialSnapshot& s = snapshots[column];
      const int axis = planes[row], right = (axis + 1) % 3, up = (axis + 2) % 3;
      const Point middle{left + (size + gap) * static_cast<double>(column) + size / 2,
                         title_height + 14 + (size + gap) * static_cast<double>(row) + size / 2};
      const double pixels = size / 2 / 1.1;
      const auto at = [&](double x, double y) { return Point{middle.x + pixels * x, middle.y - pixels * y}; };
      for (const auto& copy : s.copies) {
        Vector3 normal{};
        normal[axis] = 1;
        if (fe::norm(mapped(copy, normal) - normal) > 1e-9) continue;
        for (std::size_t f = 0; f < s.surface.size(); ++f) {
          if (!(s.pressure[f][axis] > 0)) continue;
          Polygon polygon;
          polygon.fill = colours[static_cast<std::size_t>(range.level(s.pressure[f][axis] / sigma_ref_Pa))];
          for (const int node : s.surface[f]) {
            const Vector3 x = mapped(copy, s.nodes[node]);
            polygon.ring.push_back(at(x[right], x[up]));
          }
          scene.items.push_back(polygon);
        }
      }
      scene.items.push_back(
          Line{{at(-1.1, -1.1), at(1.1, -1.1), at(1.1, 1.1), at(-1.1, 1.1), at(-1.1, -1.1)}, ink, 1});
      for (const double tick_at : {-1.0, 0.0, 1.0}) {
        const Point x = at(tick_at, -1.1), y = at(-1.1, tick_at);
        scene.items.push_back(Line{{x, {x.x, x.y + 4}}, ink, 1});
        scene.items.push_back(Line{{y, {y.x - 4, y.y}}, ink, 1});
        scene.items.push_back(
            Text{{x.x, x.y + 18}, fmt::format("{:g}", tick_at), 12, Anchor::middle, ink, false});
        scene.items.push_back(
            Text{{y.x - 8, y.y + 4}, fmt::format("{:g}", tick_at), 12, Anchor::end, ink, false});
      }
      scene.items.push_back(Text{{middle.x, at(0, -1.1).y + 34},
                                 fmt::format("{}/R₀", names[right]),
                                 12,
                                 Anchor::middle,
                                 ink,
                                 false});
      scene.items.push_back(Text{{at(-1.1, 0).x - 28, at(0, 1.1).y + 10},
                                 fmt::format("{}/R₀", names[up]),
                                 12,
                                 Anchor::middle,
                                 ink,
                                 false});
      scene.items.push_back(Text{{middle.x, at(0, 1.1).y - 6},
                                 fmt::format("plane {}, {}", names[axis], overlaps_text(s)),
                                 13,
                                 Anchor::middle,
                                 ink,
                                 false});
    }
  const double below = title_height + (size + gap) * static_cast<double>(planes.size()) + 8;
  (void)colour_bar(scene, {left, below}, "contact pressure/σ_ref", range);
  write(scene, file);
}

void contacts_picture(const press::Curve& curve, const std::filesystem::path& file) {
  struct Plane {
    const char* name;
    const char* colour;
    int index; ///< in a row of the curve
  };
  constexpr std::array planes = {Plane{"z", "#0072b2", 0}, Plane{"x", "#d55e00", 1},
                                 Plane{"y", "#009e73", 2}};
  std::string script =
      terminal(file, 760, 900) +
      fmt::format("set border 3 lc rgb '{0}' lw 1\nset tics nomirror out scale 0.5 tc rgb '{0}'\n"
                  "set grid xtics ytics lc rgb '#e3e7eb' lt 1 lw 1\nset key outside center top horizontal "
                  "Left reverse samplen 2 "
                  "tc rgb '{0}'\nset xrange [0:*]\nset yrange [0:*]\nset lmargin at screen 0.13\n"
                  "set rmargin at screen 0.96\n",
                  ink);
  const double R = curve.radius_m, unit = std::numbers::pi * R * R * curve.sigma_ref_Pa;
  std::vector<const Plane*> shown;
  for (const auto& plane : planes) {
    std::string data;
    bool touched = false;
    int branch = 0;
    for (const auto& p : curve.points) {
      if (p.branch_id != branch) data += '\n';
      branch = p.branch_id;
      const press::PlanePoint& at = p.plane(plane.index);
      touched = touched || at.force_N > 0;
      data += fmt::format("{:.8g} {:.8g} {:.8g} {:.8g}\n", p.delta_bar,
                          at.force_N > 0 ? at.mean_pressure_Pa / curve.sigma_ref_Pa : 0,
                          at.contact_radius_m / R, at.force_N / unit);
    }
    // Planes along y that do what those along x do are drawn once.
    const bool again =
        plane.index == 2 && std::all_of(curve.points.begin(), curve.points.end(), [](const auto& p) {
          const auto& [x, y] = p.side;
          return y.force_N == 0 || (y.force_N == x.force_N && y.delta_m == x.delta_m);
        });
    if (!touched || again) continue;
    shown.push_back(&plane);
    script += fmt::format("${} << EOD\n{}EOD\n", plane.name, data);
  }
  if (shown.empty()) throw core::InvalidInput("no plane is touched, so there is nothing to draw");
  script += "set multiplot\n";
  constexpr std::array<const char*, 3> quantity = {"mean pressure/σ_{ref}", "contact radius a/R_0",
                                                   "force F/(πR_0^2σ_{ref})"};
  for (int row = 0; row < 3; ++row) {
    script += fmt::format("set tmargin at screen {:.3f}\nset bmargin at screen {:.3f}\n", 0.945 - 0.305 * row,
                          0.70 - 0.305 * row);
    script += row == 0 ? fmt::format("set title {} noenhanced tc rgb '{}'\n",
                                     gnuplot_string(fmt::format("{}, {}, R₀ = {:.4g} mm", curve.material,
                                                                curve.experiment, 1e3 * R)),
                                     ink)
                       : "unset title\nunset key\n";
    script += fmt::format("set xlabel {}\nset ylabel '{}' tc rgb '{}'\nplot ",
                          row == 2 ? "'overlap of the planes along z  δ/R_0'" : "''", quantity[row], ink);
    for (std::size_t k = 0; k < shown.size(); ++k)
      script += fmt::format("{}${} using 1:{} with lines lw 2.2 lc rgb '{}' title 'plane along {}'",
                            k ? ", " : "", shown[k]->name, row + 2, shown[k]->colour, shown[k]->name);
    script += '\n';
  }
  run_gnuplot(script + "unset multiplot\n", file);
}

} // namespace platen::plot
