#include "plot/field_map.hpp"

#include "core/error.hpp"
#include "plot/axes.hpp"
#include "plot/section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace platen::plot {

namespace {

/// Steps of colour between the ends of the scale: fine enough to look smooth, coarse enough for small files.
constexpr int levels = 48;

/// viridis (van der Walt and Smith, CC0) at tenths of its length; between them linear in sRGB.
constexpr std::array<std::array<int, 3>, 11> viridis = {{{68, 1, 84},
                                                         {72, 36, 117},
                                                         {65, 68, 135},
                                                         {53, 95, 141},
                                                         {42, 120, 142},
                                                         {33, 145, 140},
                                                         {34, 168, 132},
                                                         {68, 191, 112},
                                                         {122, 209, 81},
                                                         {189, 223, 38},
                                                         {253, 231, 37}}};

std::vector<std::string> palette() {
  std::vector<std::string> result;
  for (int level = 0; level < levels; ++level) {
    const double position = 10.0 * level / (levels - 1);
    const std::size_t i = std::min<std::size_t>(9, static_cast<std::size_t>(position));
    std::array<long, 3> rgb{};
    for (std::size_t c = 0; c < 3; ++c)
      rgb[c] = std::lround(viridis[i][c] +
                           (position - static_cast<double>(i)) * (viridis[i + 1][c] - viridis[i][c]));
    result.push_back(fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]));
  }
  return result;
}

/// Element values averaged to the nodes.
std::vector<double> nodal(const press::Snapshot& snapshot, const std::vector<double>& values) {
  std::vector<double> sum(snapshot.nodes.size(), 0), count(snapshot.nodes.size(), 0);
  for (std::size_t e = 0; e < snapshot.quads.size(); ++e)
    for (const int node : snapshot.quads[e]) {
      sum[static_cast<std::size_t>(node)] += values[e];
      count[static_cast<std::size_t>(node)] += 1;
    }
  for (std::size_t n = 0; n < sum.size(); ++n) sum[n] /= std::max(count[n], 1.0);
  return sum;
}

/// Bilinear interpolation of nodal values to the middle of the quarter at a corner.
double at_quarter(const press::Snapshot& snapshot, const std::vector<double>& at_nodes, std::size_t element,
                  std::size_t corner) {
  constexpr std::array<double, 4> weight = {9.0 / 16, 3.0 / 16, 1.0 / 16, 3.0 / 16};
  double value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value += weight[i] * at_nodes[static_cast<std::size_t>(snapshot.quads[element][(corner + i) % 4])];
  return value;
}

struct Range {
  double low, high;
};

/// Smallest range with ends of two digits or so that holds all values.
Range round_range(double low, double high) {
  if (!(high > low)) { // a constant field: one colour, in the middle of a scale one unit wide
    const double half = low == 0 ? 0.5 : std::abs(low) * 0.05;
    return {low - half, low + half};
  }
  const double step = std::pow(10, std::floor(std::log10(high - low)) - 1);
  return {step * std::floor(low / step + 1e-9), step * std::ceil(high / step - 1e-9)};
}

void add_colour_bar(Sections& page, const std::vector<std::string>& colours, const std::string& name,
                    Range range) {
  const double x = page.margin, y = page.legend_top + 4, width = 240, height = 12;
  for (int level = 0; level < levels; ++level) {
    const double left = x + width * level / levels, right = x + width * (level + 1) / levels;
    page.scene.items.push_back(Polygon{{{left, y}, {right, y}, {right, y + height}, {left, y + height}},
                                       colours[static_cast<std::size_t>(level)]});
  }
  const std::array<std::pair<double, Anchor>, 3> marks = {
      {{0, Anchor::start}, {0.5, Anchor::middle}, {1, Anchor::end}}};
  for (const auto& [at, anchor] : marks)
    page.scene.items.push_back(Text{{x + at * width, y + height + 16},
                                    fmt::format("{:.4g}", range.low + at * (range.high - range.low)),
                                    13,
                                    anchor,
                                    ink,
                                    false});
  page.scene.items.push_back(Text{{x + width + 12, y + 11}, name, 14, Anchor::start, ink, false});
  page.scene.height = std::max(page.scene.height, y + height + 16 + page.margin);
}

Field scaled_stress(std::string name, std::vector<double> press::Snapshot::*stress, double sigma_ref_Pa) {
  return {std::move(name), [stress, sigma_ref_Pa](const press::Snapshot& snapshot) {
            std::vector<double> values = snapshot.*stress;
            for (double& value : values) value /= sigma_ref_Pa;
            return values;
          }};
}

} // namespace

Field relative_density() {
  return {"relative density", [](const press::Snapshot& snapshot) { return snapshot.rho_r; }};
}

Field deviatoric_stress(double sigma_ref_Pa) {
  return scaled_stress("q/σ_ref", &press::Snapshot::q, sigma_ref_Pa);
}

Field mean_stress(double sigma_ref_Pa) {
  return scaled_stress("p/σ_ref (tension positive)", &press::Snapshot::p, sigma_ref_Pa);
}

void field_map(const std::vector<press::Snapshot>& snapshots, const Field& field, const std::string& title,
               const std::filesystem::path& file) {
  check(snapshots);
  double low = INFINITY, high = -INFINITY;
  std::vector<std::vector<double>> at_nodes;
  for (const auto& snapshot : snapshots) {
    const std::vector<double> values = field.values(snapshot);
    if (values.size() != snapshot.quads.size())
      throw core::InvalidInput(
          fmt::format("snapshot at delta_bar = {:g}: {} has {} values, and there are {} elements",
                      snapshot.delta_bar, field.name, values.size(), snapshot.quads.size()));
    for (const double value : values)
      if (!std::isfinite(value))
        throw core::InvalidInput(fmt::format("snapshot at delta_bar = {:g}: a value of {} is not finite",
                                             snapshot.delta_bar, field.name));
    at_nodes.push_back(nodal(snapshot, values));
    const auto [least, most] = std::minmax_element(at_nodes.back().begin(), at_nodes.back().end());
    low = std::min(low, *least);
    high = std::max(high, *most);
  }
  const Range range = round_range(low, high);
  const SnapshotColour colour = [&](const press::Snapshot& snapshot) -> Colour {
    const auto& values = at_nodes[static_cast<std::size_t>(&snapshot - snapshots.data())];
    return [&, range](std::size_t element, std::size_t corner) {
      const double position =
          (at_quarter(snapshot, values, element, corner) - range.low) / (range.high - range.low);
      return std::clamp(static_cast<int>(levels * position), 0, levels - 1);
    };
  };
  const std::vector<std::string> colours = palette();
  Sections page = sections(snapshots, title, colour, colours);
  add_colour_bar(page, colours, field.name, range);
  page.scene.description = fmt::format("{}: {} in sections through a pressed particle", title, field.name);
  write(page.scene, file);
}

} // namespace platen::plot
