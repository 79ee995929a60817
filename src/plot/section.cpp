#include "plot/section.hpp"

#include "core/error.hpp"
#include "plot/axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace platen::plot {

namespace {

constexpr const char* pale_ink = "#5b6770";
constexpr const char* steel = "#52606d";
constexpr double margin = 24, title_size = 20, label_size = 15, gap = 20;
constexpr double widest_picture = 1000, largest_radius = 150;
constexpr std::size_t panels_a_row = 5;
constexpr double plane_thickness = 7;

std::string caption(const press::Snapshot& snapshot) {
  const char* branches[] = {"", ", unloading", ", reloading"};
  return fmt::format("δ̄ = {:.3g}{}", snapshot.delta_bar, branches[static_cast<int>(snapshot.branch)]);
}

/// The planes: bars whose faces touch the particle at z = +-(1 - delta_bar).
void add_planes(Scene& scene, const press::Snapshot& snapshot, Point centre, double radius,
                double half_width) {
  const double face = radius * (1 - snapshot.delta_bar);
  for (const double side : {-1.0, 1.0}) {
    const double near = centre.y + side * face, far = near + side * plane_thickness;
    scene.items.push_back(Polygon{{{centre.x - half_width, near},
                                   {centre.x + half_width, near},
                                   {centre.x + half_width, far},
                                   {centre.x - half_width, far}},
                                  steel});
  }
}

void add_particle(Scene& scene, const press::Snapshot& snapshot, const Colour& colour,
                  const std::vector<std::string>& palette, Point centre, double radius) {
  constexpr double tolerance_px = 0.12;
  const auto on_page = [&](std::vector<Point> ring) {
    for (Point& p : ring) p = {centre.x + radius * p.x, centre.y - radius * p.y};
    return simplified(ring, tolerance_px);
  };
  Patchwork patchwork = full_section(snapshot, colour);
  const std::vector<Region> patches = regions(patchwork);
  for (auto& cell : patchwork.cells) cell.colour = patches.front().colour;
  const std::vector<Region> whole = regions(patchwork);
  // the whole particle lies under its patches, so that no white shines through between them
  for (const Region& region : whole)
    scene.items.push_back(Polygon{on_page(region.ring), palette.at(static_cast<std::size_t>(region.colour))});
  for (const Region& region : patches)
    scene.items.push_back(Polygon{on_page(region.ring), palette.at(static_cast<std::size_t>(region.colour))});
  for (const Region& region : whole) {
    auto outline = on_page(region.ring);
    outline.push_back(outline.front());
    scene.items.push_back(Line{std::move(outline), ink, 1});
  }
}

} // namespace

void check(const std::vector<press::Snapshot>& snapshots) {
  if (snapshots.empty())
    throw core::InvalidInput("a section picture needs at least one snapshot, and got none");
  for (const auto& snapshot : snapshots) {
    const auto count = snapshot.nodes.size();
    for (const auto& quad : snapshot.elements)
      for (const int node : quad)
        if (node < 0 || static_cast<std::size_t>(node) >= count)
          throw core::InvalidInput(
              fmt::format("snapshot at delta_bar = {:g}: an element names node {}, and there are {}",
                          snapshot.delta_bar, node, count));
    for (const auto& [r, z] : snapshot.nodes)
      if (!std::isfinite(r) || !std::isfinite(z))
        throw core::InvalidInput(
            fmt::format("snapshot at delta_bar = {:g}: a node is not finite", snapshot.delta_bar));
    if (snapshot.elements.empty())
      throw core::InvalidInput(
          fmt::format("snapshot at delta_bar = {:g} has no elements", snapshot.delta_bar));
  }
}

Sections sections(const std::vector<press::Snapshot>& snapshots, const std::string& title,
                  const SnapshotColour& colour, const std::vector<std::string>& palette) {
  check(snapshots);
  double reach_r = 1, reach_z = 0; // in R0
  for (const auto& snapshot : snapshots) {
    for (const auto& node : snapshot.nodes) reach_r = std::max(reach_r, node[0]);
    reach_z = std::max(reach_z, 1 - snapshot.delta_bar);
  }
  const std::size_t columns = std::min(panels_a_row, snapshots.size());
  const std::size_t rows = (snapshots.size() + columns - 1) / columns;
  const double n = static_cast<double>(columns);
  const double radius =
      std::min(largest_radius, (widest_picture - 2 * margin - (n - 1) * gap) / (2 * reach_r * n));
  const double panel_width = 2 * reach_r * radius + gap;
  const double panel_height = 2 * reach_z * radius + 2 * plane_thickness + label_size + 26;

  Sections result;
  Scene& scene = result.scene;
  // a title of its usual length fits even over a single panel
  scene.width = std::max(2 * margin + n * panel_width - gap, 440.0);
  const double left = (scene.width - (n * panel_width - gap)) / 2;
  const double top = margin + title_size + 16;
  scene.items.push_back(
      Text{{margin, margin + 0.8 * title_size}, title, title_size, Anchor::start, ink, true});
  for (std::size_t i = 0; i < snapshots.size(); ++i) {
    const std::size_t row = i / columns;
    const Point centre{left + (static_cast<double>(i % columns) + 0.5) * panel_width - gap / 2,
                       top + static_cast<double>(row) * panel_height + plane_thickness + reach_z * radius};
    add_planes(scene, snapshots[i], centre, radius, reach_r * radius);
    add_particle(scene, snapshots[i], colour(snapshots[i]), palette, centre, radius);
    scene.items.push_back(Text{{centre.x, centre.y + reach_z * radius + plane_thickness + 10 + label_size},
                               caption(snapshots[i]),
                               label_size,
                               Anchor::middle,
                               ink,
                               false});
  }
  const double bottom = top + static_cast<double>(rows) * panel_height;
  const double bar_right = scene.width - margin, bar_y = bottom + 14;
  scene.items.push_back(
      Line{{{bar_right - radius, bar_y - 4}, {bar_right - radius, bar_y + 4}}, pale_ink, 1.5});
  scene.items.push_back(Line{{{bar_right - radius, bar_y}, {bar_right, bar_y}}, pale_ink, 1.5});
  scene.items.push_back(Line{{{bar_right, bar_y - 4}, {bar_right, bar_y + 4}}, pale_ink, 1.5});
  scene.items.push_back(
      Text{{bar_right - radius - 8, bar_y + 5}, "R₀", label_size, Anchor::end, pale_ink, false});
  constexpr double room_for_both = 640; // below this width the legend goes under the scale bar
  result.legend_top = scene.width < room_for_both ? bottom + 28 : bottom;
  result.margin = margin;
  scene.height = result.legend_top + 28 + margin;
  return result;
}

} // namespace platen::plot
