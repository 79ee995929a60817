#include "plot/colour_scale.hpp"

#include "plot/axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace platen::plot {
namespace {

/// viridis (van der Walt and Smith, CC0) at tenths of its length; between them linear in sRGB.
constexpr std::array<std::array<int, 3>, 11> map = {{{68, 1, 84},
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

} // namespace

std::vector<std::string> viridis() {
  std::vector<std::string> result;
  for (int level = 0; level < levels; ++level) {
    const double position = 10.0 * level / (levels - 1);
    const std::size_t i = std::min<std::size_t>(9, static_cast<std::size_t>(position));
    std::array<long, 3> rgb{};
    for (std::size_t c = 0; c < 3; ++c)
      rgb[c] = std::lround(map[i][c] + (position - static_cast<double>(i)) * (map[i + 1][c] - map[i][c]));
    result.push_back(fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]));
  }
  return result;
}

int Range::level(double value) const {
  return std::clamp(static_cast<int>(levels * (value - low) / (high - low)), 0, levels - 1);
}

Range round_range(double low, double high) {
  if (!(high > low)) { // a constant field: one colour, in the middle of a scale one unit wide
    const double half = low == 0 ? 0.5 : std::abs(low) * 0.05;
    return {low - half, low + half};
  }
  const double step = std::pow(10, std::floor(std::log10(high - low)) - 1);
  return {step * std::floor(low / step + 1e-9), step * std::ceil(high / step - 1e-9)};
}

double colour_bar(Scene& scene, Point at, const std::string& name, Range range) {
  constexpr double width = 240, height = 12;
  const auto colours = viridis();
  for (int level = 0; level < levels; ++level) {
    const double left = at.x + width * level / levels, right = at.x + width * (level + 1) / levels;
    scene.items.push_back(
        Polygon{{{left, at.y}, {right, at.y}, {right, at.y + height}, {left, at.y + height}},
                colours[static_cast<std::size_t>(level)]});
  }
  const std::array<std::pair<double, Anchor>, 3> marks = {
      {{0, Anchor::start}, {0.5, Anchor::middle}, {1, Anchor::end}}};
  for (const auto& [share, anchor] : marks)
    scene.items.push_back(Text{{at.x + share * width, at.y + height + 16},
                               fmt::format("{:.4g}", range.low + share * (range.high - range.low)),
                               13,
                               anchor,
                               ink,
                               false});
  scene.items.push_back(Text{{at.x + width + 12, at.y + 11}, name, 14, Anchor::start, ink, false});
  return at.y + height + 16;
}

} // namespace platen::plot
